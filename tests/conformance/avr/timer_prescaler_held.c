// TSM holds a prescaler at 0; clearing TSM starts the timers at the same time.
// Source: DS40002061B, 17.4.1
// Expect: 00 00 81 00 00 00 81 01 01 00
// Chips: atmega328p atmega2560 atmega32u4
// Host: not simulated: TSM
#include "cycles.h"

static inline void hold(void) {
  GTCCR = _BV(TSM) | _BV(PSRSYNC);
  TCCR0B = _BV(CS01);
  TCCR1B = _BV(CS11);
  TCNT0 = 0;
  TCNT1 = 0;
  NOPS(100);
  report(TCNT0);
  report(TCNT1L);
  report(GTCCR);
}

int main(void) {
  hold();
  report(OUT_IN(GTCCR, 0, 7, TCNT0));
  hold();
  report(OUT_IN(GTCCR, 0, 8, TCNT0));
  report(TCNT1L);
  report(GTCCR);
  end_program();
}
