// If OCR0A is lowered below TCNT0, the counter runs to MAX, overflows, and is cleared by the next match.
// Source: DS40002061B, 15.7.2
// Expect: 44 ff 00 01 20 00
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

int main(void) {
  OCR0A = 200;
  TCCR0A = _BV(WGM01);
  TCCR0B = _BV(CS00);
  report(OUT_OUT_IN(TCNT0, 0x40, OCR0A, 0x20, 3, TCNT0));
  TCNT0 = 0x80;
  TIFR0 = _BV(TOV0);
  report(OUT_IN(TCNT0, 0xFE, 1, TCNT0));
  report(OUT_IN(TCNT0, 0xFE, 2, TCNT0));
  report(TIFR0 & _BV(TOV0));
  report(OUT_IN(TCNT0, 0x1E, 2, TCNT0));
  report(OUT_IN(TCNT0, 0x1E, 3, TCNT0));
  end_program();
}
