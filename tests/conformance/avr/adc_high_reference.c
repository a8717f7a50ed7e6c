// REFS = 3 selects the 2.56 V reference. Channel 0x1E is the bandgap, and reads 440 of 1024; with MUX5 it is
// not the bandgap.
// Source: 2549Q, 26.8.1, tables 26-3 and 26-4
// Expect: 01 b8 00 00
// Chips: atmega2560 atmega32u4
#include "report.h"

static void convert(uint8_t multiplexer, uint8_t control_b) {
  ADMUX = multiplexer;
  ADCSRB = control_b;
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  while (ADCSRA & _BV(ADSC)) {
  }
  report_word(ADC);
}

int main(void) {
  convert(_BV(REFS1) | _BV(REFS0) | 0x1E, 0);
  convert(_BV(REFS1) | _BV(REFS0) | 0x1E, _BV(MUX5));
  end_program();
}
