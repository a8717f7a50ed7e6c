// A timer that is switched to the processor's clock counts from the next cycle on.
// Source: DS40002061B, 15.4
// Expect: 00 01 02 00 01 02
// Chips: atmega328p atmega2560
// Host: cycles
#include "cycles.h"

static inline void stop(void) {
  TCCR0B = TCCR2B = 0;
  TCNT0 = TCNT2 = 0;
}

int main(void) {
  report(OUT_IN(TCCR0B, _BV(CS00), 0, TCNT0));
  stop();
  report(OUT_IN(TCCR0B, _BV(CS00), 1, TCNT0));
  stop();
  report(OUT_IN(TCCR0B, _BV(CS00), 2, TCNT0));
  report(0);
  stop();
  report(STS_LDS(TCCR2B, _BV(CS20), 0, TCNT2));
  stop();
  report(STS_LDS(TCCR2B, _BV(CS20), 1, TCNT2));
  end_program();
}
