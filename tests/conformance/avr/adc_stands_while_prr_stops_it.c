// PRADC stops the converter: its registers read 0 and ignore writes.
// Source: DS40002061B, 10.10, 10.11.3
// Expect: 00 80 4e
// Chips: atmega328p attiny85
// Host: not simulated: PRR
#include "report.h"

int main(void) {
  ADMUX = _BV(REFS0) | 14;
  ADCSRA = _BV(ADEN);
  PRR = _BV(PRADC);
  ADMUX = 3;
  report(ADCSRA);
  PRR = 0;
  report(ADCSRA);
  report(ADMUX);
  end_program();
}
