// If ADIF is set before ADIE, setting ADIE requests the interrupt; entering the vector clears ADIF.
// Source: DS40002061B, 24.9.2
// Expect: 90 01 88
// Chips: atmega328p atmega2560 atmega32u4 attiny85
#include "report.h"

static volatile uint8_t served;
ISR(ADC_vect) { ++served; }

int main(void) {
  sei();
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  __builtin_avr_delay_cycles(60);
  report(ADCSRA);
  ADCSRA = _BV(ADEN) | _BV(ADIE);
  NOPS(4);
  report(served);
  report(ADCSRA);
  end_program();
}
