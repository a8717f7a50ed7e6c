// Data written while UDRE is 0 is ignored: of three bytes written at once, two are sent.
// Source: DS40002061B, 20.6.1
// Expect: 20 60
// Chips: atmega328p atmega2560
#include "report.h"

#define STATUS_AFTER(cycles)                  \
  ({                                          \
    UCSR0A = _BV(TXC0);                       \
    UDR0 = 1;                                 \
    UDR0 = 1;                                 \
    UDR0 = 1;                                 \
    __builtin_avr_delay_cycles((cycles) - 8); \
    uint8_t status = UCSR0A;                  \
    __builtin_avr_delay_cycles(500);          \
    status;                                   \
  })

int main(void) {
  UCSR0B = _BV(TXEN0);
  report(STATUS_AFTER(317));
  report(STATUS_AFTER(325));
  end_program();
}
