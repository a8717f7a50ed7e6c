// With ISC0 = 0 the interrupt is requested as long as the pin is low, without setting a flag.
// Source: DS40002061B, 13.2.1, 13.2.3
// Expect: 00 03 00
#include "report.h"

static volatile uint8_t served;
ISR(INT0_vect) {
  if (++served == 3) PORTD = _BV(PORTD2);
}

int main(void) {
  PORTD = _BV(PORTD2);
  DDRD = _BV(DDD2);
  EIMSK = _BV(INT0);
  sei();
  NOPS(10);
  report(served);
  PORTD = 0;
  NOPS(10);
  report(served);
  report(EIFR);
  end_program();
}
