// ADTS = 6 starts a conversion by the flag of a pin change.
// Source: 2586Q, 17.4, table 17-6
// Expect: 20 10
// Chips: attiny85
#include "report.h"

int main(void) {
  DDRB = _BV(DDB0);
  PCMSK = _BV(PCINT0);
  ADCSRB = _BV(ADTS2) | _BV(ADTS1);
  ADCSRA = _BV(ADEN) | _BV(ADATE);
  NOPS(100);
  report(ADCSRA & (_BV(ADIF) | _BV(ADATE)));
  PORTB = _BV(PB0);
  NOPS(100);
  report(ADCSRA & _BV(ADIF));
  end_program();
}
