// SBI and CBI change only the bit they name: ACI and ADIF stay set, and writing 1 clears them.
// Source: 2586Q, the register summary's notes
// Expect: 10 10 00 10 10 00
// Chips: attiny85
#include "report.h"

int main(void) {
  DDRB = _BV(DDB0);
  ACSR = 0;
  PORTB = _BV(PORTB0);
  NOPS(4);
  ACSR |= _BV(ACIS0);
  report(ACSR & _BV(ACI));
  ACSR &= ~_BV(ACIS0);
  report(ACSR & _BV(ACI));
  ACSR |= _BV(ACI);
  report(ACSR & _BV(ACI));
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  NOPS(200);
  ADCSRA |= _BV(ADIE);
  report(ADCSRA & _BV(ADIF));
  ADCSRA &= ~_BV(ADIE);
  report(ADCSRA & _BV(ADIF));
  ADCSRA |= _BV(ADIF);
  report(ADCSRA & _BV(ADIF));
  end_program();
}
