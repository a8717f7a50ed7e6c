// Setting the trigger's flag starts a conversion: the prescaler restarts 3 cycles later, and the conversion
// ends after 13.5 clocks.
// Source: DS40002061B, 24.3, 24.4, table 24-1
// Expect: e0 b0
// Host: not simulated: ADTS
#include "report.h"

// INTF0 is set 2 cycles after the edge, the prescaler starts at cycle 5, and the conversion ends at 5 + 13.5
// * 2 = 32.
#define CONTROL_AFTER(cycles)                         \
  ({                                                  \
    PORTD &= (uint8_t)~_BV(PORTD2);                   \
    EIFR = _BV(INTF0);                                \
    ADCSRA = _BV(ADEN) | _BV(ADATE) | _BV(ADIF);      \
    PORTD |= _BV(PORTD2);                             \
    __builtin_avr_delay_cycles((cycles) - 2);         \
    uint8_t control = ADCSRA;                         \
    control;                                          \
  })

int main(void) {
  DDRD = _BV(DDD2);
  EICRA = _BV(ISC01) | _BV(ISC00);
  ADCSRB = _BV(ADTS1);
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  __builtin_avr_delay_cycles(60);
  report(CONTROL_AFTER(31));
  __builtin_avr_delay_cycles(60);
  report(CONTROL_AFTER(32));
  end_program();
}
