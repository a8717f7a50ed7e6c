// A conversion starts at the next rising edge of the ADC's clock, which has run since ADEN was set. Starts
// between two edges therefore end at the same time.
// Source: DS40002061B, 24.4
// Expect: c7 97 c7 97
// Ends: 200000
// Chips: atmega328p atmega2560 atmega32u4
// Host: differs: phase of the ADC's clock
#include "report.h"

// ADEN is set at cycle 0. Rising edges are at 64 + 128 k, and the first conversion ends at 64 + 25 * 128 =
// 3264. A conversion requested in the next 128 cycles begins at 3392 and ends at 3392 + 13 * 128 = 5056.
#define CONTROL(start_at, read_at)                              \
  ({                                                            \
    ADCSRA = 0;                                                 \
    ADCSRA = _BV(ADEN) | _BV(ADIF) | _BV(ADSC) | 7;             \
    __builtin_avr_delay_cycles((start_at) - 2);                 \
    ADCSRA = _BV(ADEN) | _BV(ADIF) | _BV(ADSC) | 7;             \
    __builtin_avr_delay_cycles((read_at) - (start_at) - 2);     \
    uint8_t control = ADCSRA;                                   \
    control;                                                    \
  })

int main(void) {
  report(CONTROL(3266, 5055));
  report(CONTROL(3266, 5056));
  report(CONTROL(3390, 5055));
  report(CONTROL(3390, 5056));
  end_program();
}
