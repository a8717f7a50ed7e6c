// ADEN = 0 ends a conversion without setting ADIF; the next conversion is timed like the first one.
// Source: DS40002061B, 24.4, 24.9.2
// Expect: 00 c0 90
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: differs: phase of the ADC's clock
#include "report.h"

int main(void) {
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  __builtin_avr_delay_cycles(30);
  ADCSRA = 0;
  __builtin_avr_delay_cycles(60);
  report(ADCSRA);
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  __builtin_avr_delay_cycles(48);
  report(ADCSRA);
  __builtin_avr_delay_cycles(10);
  report(ADCSRA);
  end_program();
}
