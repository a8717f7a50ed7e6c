// Fast PWM with OCR0A as TOP counts OCR0A + 1 clocks, and overflows at TOP.
// Source: DS40002061B, 15.7.3
// Expect: 09 00 01 00 01
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

int main(void) {
  OCR0A = 9;
  TCCR0A = _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(WGM02) | _BV(CS00);
  report(OUT_IN(TCNT0, 8, 1, TCNT0));
  report(OUT_IN(TCNT0, 8, 2, TCNT0));
  report(OUT_IN(TCNT0, 8, 3, TCNT0));
  TCNT0 = 100;
  TIFR0 = _BV(TOV0);
  report(OUT_IN(TCNT0, 8, 1, TIFR0) & _BV(TOV0));
  TCNT0 = 100;
  TIFR0 = _BV(TOV0);
  report(OUT_IN(TCNT0, 8, 2, TIFR0) & _BV(TOV0));
  end_program();
}
