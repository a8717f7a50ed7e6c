// PRUSART0 stops the clock of the USART: its registers read 0, and its frame continues once the bit is
// cleared.
// Source: DS40002061B, 10.10, 10.11.3
// Expect: 00 20 60
// Host: not simulated: PRR
#include "report.h"

#define STATUS_AFTER(cycles)                           \
  ({                                                   \
    UCSR0A = _BV(TXC0);                                \
    UDR0 = 2;                                          \
    PRR = _BV(PRUSART0);                               \
    __builtin_avr_delay_cycles(298);                   \
    PRR = 0;                                           \
    __builtin_avr_delay_cycles((cycles) - 300 - 2 - 2); \
    uint8_t status = UCSR0A;                           \
    __builtin_avr_delay_cycles(500);                   \
    status;                                            \
  })

int main(void) {
  UCSR0B = _BV(TXEN0);
  PRR = _BV(PRUSART0);
  report(UCSR0A);
  PRR = 0;
  report(STATUS_AFTER(300 + 159));
  report(STATUS_AFTER(300 + 160));
  end_program();
}
