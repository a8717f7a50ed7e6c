// Writing 1 to ADIF clears it; writing 0 leaves it unchanged. Writing back a value read from ADCSRA therefore
// clears ADIF.
// Source: DS40002061B, 24.9.2
// Expect: 90 90 80
// Chips: atmega328p atmega2560 atmega32u4 attiny85
#include "report.h"

int main(void) {
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  __builtin_avr_delay_cycles(60);
  report(ADCSRA);
  ADCSRA = _BV(ADEN);
  report(ADCSRA);
  ADCSRA |= 0;
  report(ADCSRA);
  end_program();
}
