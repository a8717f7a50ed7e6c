// The first conversion after ADEN takes 25 clocks of the ADC. It starts at the ADC clock's first rising edge,
// half a clock after ADEN.
// Source: DS40002061B, 24.4, table 24-1
// Expect: c0 90
// Chips: atmega328p atmega2560 atmega32u4
// Host: differs: phase of the ADC's clock
#include "report.h"

// The conversion ends 1 + 25 * 2 cycles after ADEN.
#define CONTROL_AFTER(cycles)                 \
  ({                                          \
    ADCSRA = 0;                               \
    ADCSRA = _BV(ADIF);                       \
    ADCSRA = _BV(ADEN) | _BV(ADSC);           \
    __builtin_avr_delay_cycles((cycles) - 2); \
    uint8_t control = ADCSRA;                 \
    control;                                  \
  })

int main(void) {
  report(CONTROL_AFTER(50));
  report(CONTROL_AFTER(51));
  end_program();
}
