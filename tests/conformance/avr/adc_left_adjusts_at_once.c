// ADLAR shifts the result of the last conversion when it is read.
// Source: DS40002061B, 24.9.1, 24.9.3
// Expect: 00 e1 38 40 00 e1
#include "report.h"

int main(void) {
  ADMUX = _BV(REFS0) | 14;
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  __builtin_avr_delay_cycles(60);
  report_word(ADC);
  ADMUX = _BV(REFS0) | _BV(ADLAR) | 14;
  report_word(ADC);
  ADMUX = _BV(REFS0) | 14;
  report_word(ADC);
  end_program();
}
