// A pin's own output passes the synchroniser: IN directly after OUT returns the old level, one cycle later
// the new level.
// Source: DS40002061B, 14.2.4, figures 14-3 and 14-4
// Expect: 00 20 20 00
// Host: cycles
#include "cycles.h"

int main(void) {
  DDRB = _BV(DDB5);
  NOPS(4);
  report(OUT_IN(PORTB, _BV(PORTB5), 0, PINB) & _BV(PINB5));
  NOPS(4);
  PORTB = 0;
  NOPS(4);
  report(OUT_IN(PORTB, _BV(PORTB5), 1, PINB) & _BV(PINB5));
  NOPS(4);
  report(OUT_IN(PORTB, 0, 0, PINB) & _BV(PINB5));
  PORTB = _BV(PORTB5);
  NOPS(4);
  report(OUT_IN(PORTB, 0, 1, PINB) & _BV(PINB5));
  end_program();
}
