// ADMUX is latched when the conversion starts, not when ADSC is written; later writes apply to the next
// conversion.
// Source: DS40002061B, 24.5
// Expect: 00 e1 00 00
// Host: differs: phase of the ADC's clock
#include "report.h"

// The first rising edge comes 64 cycles after ADEN.
#define CODE(cycles)                                  \
  ({                                                  \
    ADCSRA = 0;                                       \
    ADMUX = _BV(REFS0) | 15;                          \
    ADCSRA = _BV(ADEN) | _BV(ADSC) | 7;               \
    __builtin_avr_delay_cycles((cycles) - 3);         \
    ADMUX = _BV(REFS0) | 14;                          \
    while (ADCSRA & _BV(ADSC)) {                      \
    }                                                 \
    ADC;                                              \
  })

int main(void) {
  report_word(CODE(40));
  report_word(CODE(90));
  end_program();
}
