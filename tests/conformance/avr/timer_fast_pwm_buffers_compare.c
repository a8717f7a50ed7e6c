// In fast PWM a write to OCR0A takes effect at BOTTOM, although reads return the new value immediately.
// Source: DS40002061B, 15.7.3, table 15-8
// Expect: 06 09 00 04 00 04
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: cycles
#include "cycles.h"

static inline void begin(void) {
  TCCR0A = 0;
  TCCR0B = 0;
  OCR0A = 9;
  TCCR0A = _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(WGM02) | _BV(CS00);
}

int main(void) {
  begin();
  report(OUT_OUT_IN(TCNT0, 2, OCR0A, 4, 3, TCNT0));
  begin();
  report(OUT_OUT_IN(TCNT0, 2, OCR0A, 4, 6, TCNT0));
  begin();
  report(OUT_OUT_IN(TCNT0, 2, OCR0A, 4, 7, TCNT0));
  begin();
  report(OUT_OUT_IN(TCNT0, 2, OCR0A, 4, 11, TCNT0));
  begin();
  report(OUT_OUT_IN(TCNT0, 2, OCR0A, 4, 12, TCNT0));
  begin();
  report(OUT_OUT_IN(TCNT0, 2, OCR0A, 4, 0, OCR0A));
  end_program();
}
