// In phase correct PWM TOV0 is set by the clock that leaves BOTTOM.
// Source: DS40002061B, 15.7.4
// Expect: 00 01
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

static inline void begin(void) {
  TCCR0B = 0;
  TCCR0A = 0;
  OCR0A = 3;
  TCNT0 = 2;
  TIFR0 = _BV(TOV0);
  TCCR0A = _BV(WGM00);
}

int main(void) {
  begin();
  report(OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), 4, TIFR0) & _BV(TOV0));
  begin();
  report(OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), 5, TIFR0) & _BV(TOV0));
  end_program();
}
