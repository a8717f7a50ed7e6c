// With CTC1 timer 1 restarts after a match with OCR1C, without overflow; without CTC1 it runs on to 0xFF and
// overflows.
// Source: 2586Q, 12.3.1, 12.3.6, 12.3.8
// Expect: ff 09 00 40 0a 44
// Chips: attiny85
#include "timer1.h"

int main(void) {
  report(OCR1C);
  OCR1C = 9;
  OCR1A = 5;
  OCR1B = 200;
  TCCR1 = _BV(CTC1) | CLOCK_BY_64;
  report(AFTER_HALF_TICKS(8, 3, TCNT1));
  report(AFTER_HALF_TICKS(8, 5, TCNT1));
  TIFR = 0xFF;
  report(AFTER_HALF_TICKS(0, 51, TIFR));
  TCCR1 = CLOCK_BY_64;
  report(AFTER_HALF_TICKS(8, 5, TCNT1));
  TIFR = 0xFF;
  report(AFTER_HALF_TICKS(250, 25, TIFR));
  end_program();
}
