// With clear on match, a timer counts OCR0A + 1 clocks, and does not overflow below MAX.
// Source: DS40002061B, 15.7.2
// Expect: 62 63 00 01 02
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

int main(void) {
  OCR0A = 99;
  TCCR0A = _BV(WGM01);
  TCCR0B = _BV(CS00);
  report(OUT_IN(TCNT0, 97, 1, TCNT0));
  report(OUT_IN(TCNT0, 97, 2, TCNT0));
  report(OUT_IN(TCNT0, 97, 3, TCNT0));
  report(OUT_IN(TCNT0, 97, 4, TCNT0));
  NOPS(300);
  report(TIFR0 & (_BV(OCF0A) | _BV(TOV0)));
  end_program();
}
