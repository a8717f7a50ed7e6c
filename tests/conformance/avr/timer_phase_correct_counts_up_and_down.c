// A timer in phase correct PWM counts up to TOP, down to 0, and up again.
// Source: DS40002061B, 15.7.4
// Expect: 02 03 02 01 00 01
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
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
  report(OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), 0, TCNT0));
  begin();
  report(OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), 1, TCNT0));
  begin();
  report(OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), 2, TCNT0));
  begin();
  report(OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), 3, TCNT0));
  begin();
  report(OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), 4, TCNT0));
  begin();
  report(OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), 5, TCNT0));
  end_program();
}
