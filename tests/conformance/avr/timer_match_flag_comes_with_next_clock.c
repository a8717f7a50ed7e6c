// OCF0A is set by the timer's clock that ends the match.
// Source: DS40002061B, 15.6, figure 15-10
// Expect: 00 02 00 02
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

int main(void) {
  OCR0A = 0x14;
  OCR0B = 0xFF;
  TCCR0B = _BV(CS00);
  TCNT0 = 0x80;
  TIFR0 = 0x07;
  report(OUT_IN(TCNT0, 0x10, 4, TIFR0));
  TCNT0 = 0x80;
  TIFR0 = 0x07;
  report(OUT_IN(TCNT0, 0x10, 5, TIFR0));
  TCCR0B = _BV(CS01) | _BV(CS00);
  TCNT0 = 0x12;
  TIFR0 = 0x07;
  while (TCNT0 != 0x14) {
  }
  report(TIFR0);
  while (TCNT0 != 0x15) {
  }
  report(TIFR0);
  end_program();
}
