// A trigger flag that stays set does not start another conversion: it must be cleared first.
// Source: DS40002061B, 24.3
// Expect: b0 a0 b0
// Host: not simulated: ADTS
#include "report.h"

static void pulse(void) {
  PIND = _BV(PIND2);
  PIND = _BV(PIND2);
  __builtin_avr_delay_cycles(100);
  report(ADCSRA);
  ADCSRA |= _BV(ADIF);
}

int main(void) {
  DDRD = _BV(DDD2);
  EICRA = _BV(ISC01) | _BV(ISC00);
  ADCSRB = _BV(ADTS1);
  ADCSRA = _BV(ADEN) | _BV(ADATE);
  pulse();
  pulse();
  EIFR = _BV(INTF0);
  pulse();
  end_program();
}
