// If a program waits for ADIF and clears it by writing 1, every conversion returns its own channel's result.
// Source: DS40002061B, 24.9.2
// Expect: 00 e1 00 00 00 e1 00 00
#include "report.h"

static uint16_t code_of(uint8_t channel) {
  ADMUX = _BV(REFS0) | channel;
  ADCSRA |= _BV(ADSC);
  while (!(ADCSRA & _BV(ADIF))) {
  }
  ADCSRA |= _BV(ADIF);
  return ADC;
}

int main(void) {
  ADCSRA = _BV(ADEN) | 5;
  for (uint8_t i = 0; i < 2; ++i) {
    report_word(code_of(14));
    report_word(code_of(15));
  }
  end_program();
}
