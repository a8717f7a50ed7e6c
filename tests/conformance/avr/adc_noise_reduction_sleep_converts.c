// Entering ADC noise reduction mode starts a conversion, whose interrupt wakes the chip.
// Source: DS40002061B, 10.4, 24.6
// Expect: a1 00 e1 02
// Host: not simulated: sleep modes other than idle
#include "report.h"

ISR(ADC_vect) { report(0xA1); }

int main(void) {
  ADMUX = _BV(REFS0) | 14;
  ADCSRA = _BV(ADEN) | _BV(ADIE) | 7;
  SMCR = _BV(SM0) | _BV(SE);
  sei();
  sleep_cpu();
  report_word(ADC);
  report(2);
  end_program();
}
