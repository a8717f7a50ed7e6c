// An edge that occurs before EIMSK enables INT0 is remembered, and served once INT0 is enabled; entering the
// vector clears the flag.
// Source: DS40002061B, 13.2.2, 13.2.3
// Expect: 00 01 01 00
#include "report.h"

static volatile uint8_t served;
ISR(INT0_vect) { ++served; }

int main(void) {
  DDRD = _BV(DDD2);
  EICRA = _BV(ISC01) | _BV(ISC00);
  sei();
  PORTD = _BV(PORTD2);
  NOPS(4);
  report(served);
  report(EIFR);
  EIMSK = _BV(INT0);
  NOPS(4);
  report(served);
  report(EIFR);
  end_program();
}
