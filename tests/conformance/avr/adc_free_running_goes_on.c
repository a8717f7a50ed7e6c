// In free running mode each conversion starts as soon as the previous one ends, regardless of ADIF, and ADSC
// stays 1.
// Source: DS40002061B, 24.3, 24.4
// Expect: f0 e0 e0 f0
// Chips: atmega328p atmega2560 atmega32u4
// Host: differs: phase of the ADC's clock
#include "report.h"

// Conversions end 51, 77, 103, … cycles after ADEN. ADIF is cleared at cycle 60.
#define CONTROL_AT(cycle)                                       \
  ({                                                            \
    ADCSRA = _BV(ADIF);                                         \
    ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADATE);                \
    __builtin_avr_delay_cycles(58);                             \
    ADCSRA = _BV(ADEN) | _BV(ADATE) | _BV(ADIF);                \
    __builtin_avr_delay_cycles((cycle) - 60 - 2);               \
    uint8_t control = ADCSRA;                                   \
    ADCSRA = 0;                                                 \
    control;                                                    \
  })

int main(void) {
  ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADATE);
  __builtin_avr_delay_cycles(70);
  report(ADCSRA);
  ADCSRA = 0;
  report(CONTROL_AT(64));
  report(CONTROL_AT(76));
  report(CONTROL_AT(77));
  end_program();
}
