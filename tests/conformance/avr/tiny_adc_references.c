// Channel 12 is the bandgap, channel 13 ground. With the references VCC (5 V), 1.1 V and 2.56 V (REFS2), the
// bandgap reads 225, 1023 and 440.
// Source: 2586Q, 17.13.1, tables 17-3 and 17-4
// Expect: 00 e1 00 00 03 ff 01 b8 01 b8
// Chips: attiny85
#include "report.h"

static void convert(uint8_t multiplexer) {
  ADMUX = multiplexer;
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  while (ADCSRA & _BV(ADSC)) {
  }
  report_word(ADC);
}

int main(void) {
  convert(12);
  convert(13);
  convert(_BV(REFS1) | 12);
  convert(_BV(REFS2) | _BV(REFS1) | 12);
  convert(_BV(REFS2) | _BV(REFS1) | _BV(REFS0) | 12);
  end_program();
}
