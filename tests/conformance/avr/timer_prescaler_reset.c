// PSRSYNC sets the prescaler of timers 0 and 1 to 0; PSRASY does the same for timer 2.
// Source: DS40002061B, 17.4.1, 18.11.9
// Expect: 00 01 00 01
// Chips: atmega328p atmega2560
#include "cycles.h"

int main(void) {
  TCCR0B = _BV(CS01) | _BV(CS00);
  TCCR2B = _BV(CS21) | _BV(CS20);
  GTCCR = _BV(PSRSYNC);
  TCNT0 = TCNT2 = 0;
  for (uint8_t i = 0; i < 100; ++i) {
    GTCCR = _BV(PSRSYNC);
    NOPS(5);
  }
  report(TCNT0);
  report(TCNT2 != 0);
  GTCCR = _BV(PSRASY);
  TCNT0 = TCNT2 = 0;
  for (uint8_t i = 0; i < 100; ++i) {
    GTCCR = _BV(PSRASY);
    NOPS(5);
  }
  report(TCNT2);
  report(TCNT0 != 0);
  end_program();
}
