// A second byte waits in the buffer with UDRE 0 until the first one is sent; TXC is set once both are sent.
// Source: DS40002061B, 20.6.3
// Expect: 20 00 00 20 20 60
// Chips: atmega328p atmega2560
#include "report.h"

#define STATUS_AFTER(cycles)                   \
  ({                                           \
    UCSR0A = _BV(TXC0);                        \
    UDR0 = 1;                                  \
    UDR0 = 1;                                  \
    __builtin_avr_delay_cycles((cycles) - 4);  \
    uint8_t status = UCSR0A;                   \
    __builtin_avr_delay_cycles(500);           \
    status;                                    \
  })

int main(void) {
  UCSR0B = _BV(TXEN0);
  report(UCSR0A);
  report(STATUS_AFTER(5));
  report(STATUS_AFTER(159));
  report(STATUS_AFTER(160));
  report(STATUS_AFTER(319));
  report(STATUS_AFTER(320));
  end_program();
}
