// A conversion takes 13 clocks of the ADC, from the first rising edge after ADSC.
// Source: DS40002061B, 24.4, table 24-1
// Expect: c0 90
// Chips: atmega328p atmega2560 atmega32u4
// Host: differs: phase of the ADC's clock
#include "report.h"

// ADEN is set at cycle 0, so rising edges are at 1 + 2 k. ADSC is set at cycle 100: the conversion runs from
// 101 to 127.
#define CONTROL_AT(cycle)                           \
  ({                                                \
    ADCSRA = 0;                                     \
    ADCSRA = _BV(ADEN) | _BV(ADIF) | _BV(ADSC);     \
    __builtin_avr_delay_cycles(98);                 \
    ADCSRA = _BV(ADEN) | _BV(ADIF) | _BV(ADSC);     \
    __builtin_avr_delay_cycles((cycle) - 100 - 2);  \
    uint8_t control = ADCSRA;                       \
    control;                                        \
  })

int main(void) {
  report(CONTROL_AT(126));
  report(CONTROL_AT(127));
  end_program();
}
