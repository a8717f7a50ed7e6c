// TOV0 is set by the clock that takes the counter from MAX to 0.
// Source: DS40002061B, 15.8, figure 15-8
// Expect: 00 01 07
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

// OCR0A and OCR0B are 0, so their flags are set one clock later.
static inline void clear(void) {
  TCNT0 = 0x80;
  TIFR0 = 0x07;
}

int main(void) {
  TCCR0B = _BV(CS00);
  clear();
  report(OUT_IN(TCNT0, 0xFE, 1, TIFR0));
  clear();
  report(OUT_IN(TCNT0, 0xFE, 2, TIFR0));
  clear();
  report(OUT_IN(TCNT0, 0xFE, 3, TIFR0));
  end_program();
}
