// With PWM1A timer 1 counts up to OCR1C and overflows there; a write to OCR1A then takes effect.
// Source: 2586Q, 12.2.2, 12.3.8
// Expect: 09 00 00 04 00 40
// Chips: attiny85
#include "timer1.h"

int main(void) {
  OCR1C = 9;
  TCCR1 = _BV(PWM1A) | CLOCK_BY_64;
  OCR1A = 8;
  AFTER_HALF_TICKS(8, 5, TCNT1);
  report(AFTER_HALF_TICKS(8, 3, TCNT1));
  report(AFTER_HALF_TICKS(8, 5, TCNT1));
  TIFR = 0xFF;
  report(AFTER_HALF_TICKS(8, 3, TIFR) & _BV(TOV1));
  report(AFTER_HALF_TICKS(8, 5, TIFR) & _BV(TOV1));
  OCR1A = 3;
  TIFR = 0xFF;
  report(AFTER_HALF_TICKS(1, 7, TIFR) & _BV(OCF1A));
  AFTER_HALF_TICKS(8, 5, TCNT1);
  TIFR = 0xFF;
  report(AFTER_HALF_TICKS(1, 7, TIFR) & _BV(OCF1A));
  end_program();
}
