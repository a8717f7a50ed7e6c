// Channel 14 measures the bandgap's 1.1 V, channel 15 ground. The bandgap reads 225 of 1024 with AVCC at 5 V,
// and full scale with the bandgap as reference.
// Source: DS40002061B, 24.7, tables 24-3 and 24-4
// Expect: 00 e1 00 00 03 ff
#include "report.h"

static void convert(uint8_t multiplexer) {
  ADMUX = multiplexer;
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  while (ADCSRA & _BV(ADSC)) {
  }
  report_word(ADC);
}

int main(void) {
  convert(_BV(REFS0) | 14);
  convert(_BV(REFS0) | 15);
  convert(_BV(REFS1) | _BV(REFS0) | 14);
  end_program();
}
