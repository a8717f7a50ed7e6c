// Timer 0 sets OCF0A, OCF0B and TOV0 in bits 4, 3 and 1 of TIFR; with clear on match it does not overflow.
// Source: 2586Q, 11.7.2, 11.9.8
// Expect: 10 18 1a 63 00 18
// Chips: attiny85
#include "cycles.h"

static void clear(void) {
  TCNT0 = 0x80;
  TIFR = 0x1A;
}

int main(void) {
  OCR0A = 0xF0;
  OCR0B = 0xF2;
  TCCR0B = _BV(CS00);
  clear();
  report(OUT_IN(TCNT0, 0xEF, 3, TIFR));
  clear();
  report(OUT_IN(TCNT0, 0xEF, 5, TIFR));
  clear();
  report(OUT_IN(TCNT0, 0xEF, 19, TIFR));
  OCR0A = 99;
  OCR0B = 50;
  TCCR0A = _BV(WGM01);
  report(OUT_IN(TCNT0, 97, 2, TCNT0));
  report(OUT_IN(TCNT0, 97, 3, TCNT0));
  clear();
  TCNT0 = 0;
  NOPS(300);
  report(TIFR);
  end_program();
}
