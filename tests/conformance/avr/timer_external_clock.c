// A timer counts the edges of its pin that CS02 to CS00 select, three cycles after each edge.
// Source: DS40002061B, 17.2
// Expect: 05 03 00 01
// Host: cycles
#include "cycles.h"

static inline void pulses(uint8_t count) {
  while (count--) {
    PORTD |= _BV(PD4);
    NOPS(4);
    PORTD &= ~_BV(PD4);
    NOPS(4);
  }
}

int main(void) {
  DDRD = _BV(PD4);
  TCCR0B = _BV(CS02) | _BV(CS01) | _BV(CS00);
  pulses(5);
  report(TCNT0);
  TCCR0B = _BV(CS02) | _BV(CS01);
  TCNT0 = 0;
  pulses(3);
  report(TCNT0);
  TCCR0B = _BV(CS02) | _BV(CS01) | _BV(CS00);
  TCNT0 = 0;
  report(OUT_IN(PORTD, _BV(PD4), 2, TCNT0));
  PORTD = 0;
  NOPS(10);
  TCNT0 = 0;
  report(OUT_IN(PORTD, _BV(PD4), 3, TCNT0));
  end_program();
}
