// Reading ADCL locks both bytes until ADCH is read. The result of a conversion that ends in between is lost;
// the next result is not.
// Source: DS40002061B, 24.2, 24.9.3
// Expect: 40 38 38 00
#include "report.h"

static void convert(uint8_t channel) {
  ADMUX = _BV(REFS0) | _BV(ADLAR) | channel;
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  while (ADCSRA & _BV(ADSC)) {
  }
}

int main(void) {
  convert(14);  // result: 0x3840
  report(ADCL);
  convert(15);  // result: 0
  report(ADCH);
  report(ADCH);
  convert(15);
  report(ADCH);
  end_program();
}
