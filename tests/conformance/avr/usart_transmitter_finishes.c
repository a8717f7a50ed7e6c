// TXEN = 0 takes effect once the shift register and the buffer are empty: TXC is set after both frames.
// Source: DS40002061B, 20.6.5
// Expect: 20 60
// Chips: atmega328p atmega2560
#include "report.h"

#define STATUS_AFTER(cycles)                  \
  ({                                          \
    UCSR0B = _BV(TXEN0);                      \
    UCSR0A = _BV(TXC0);                       \
    UDR0 = 1;                                 \
    UDR0 = 1;                                 \
    UCSR0B = 0;                               \
    __builtin_avr_delay_cycles((cycles) - 6); \
    uint8_t status = UCSR0A;                  \
    __builtin_avr_delay_cycles(500);          \
    status;                                   \
  })

int main(void) {
  report(STATUS_AFTER(318));
  report(STATUS_AFTER(320));
  end_program();
}
