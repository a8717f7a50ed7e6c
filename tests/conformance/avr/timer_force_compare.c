// FOC0A changes the pin as a match would, without setting a flag, and reads 0.
// Source: DS40002061B, 15.6.1, 15.9.2
// Expect: 40 00 40 00 00 00
#include "cycles.h"

static inline uint8_t forced(uint8_t com) {
  TCCR0A = com << COM0A0;
  TCCR0B = _BV(FOC0A);
  NOPS(2);
  return PIND & _BV(PD6);
}

int main(void) {
  DDRD = _BV(PD6);
  report(forced(3));
  report(forced(2));
  report(forced(1));
  report(forced(1));
  report(TCCR0B);
  report(TIFR0);
  end_program();
}
