// In phase correct PWM a write to OCR0A takes effect at TOP.
// Source: DS40002061B, 15.7.4, table 15-8
// Expect: 04 00 02 01
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

static inline void begin(void) {
  TCCR0B = 0;
  TCCR0A = 0;
  OCR0A = 4;
  TCNT0 = 0;
  TIFR0 = _BV(TOV0);
  TCCR0A = _BV(WGM00);
}

int main(void) {
  begin();
  report(OUT_OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), OCR0A, 2, 3, TCNT0));
  begin();
  report(OUT_OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), OCR0A, 2, 7, TCNT0));
  begin();
  report(OUT_OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), OCR0A, 2, 9, TCNT0));
  begin();
  report(OUT_OUT_IN(TCCR0B, _BV(WGM02) | _BV(CS00), OCR0A, 2, 10, TCNT0));
  end_program();
}
