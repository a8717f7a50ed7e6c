// A write to TCNT0 blocks a match, and a clear on match, at the next clock, even if the timer was stopped.
// Source: DS40002061B, 15.5.3
// Expect: 00 02 00 42
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

static inline void clear(void) {
  TCNT0 = 0x80;
  TIFR0 = 0x07;
}

int main(void) {
  OCR0A = 0x40;
  OCR0B = 0xFF;
  TCCR0B = _BV(CS00);
  clear();
  report(OUT_IN(TCNT0, 0x40, 5, TIFR0));
  clear();
  report(OUT_IN(TCNT0, 0x3F, 5, TIFR0));
  TCCR0B = 0;
  TCNT0 = 0x40;
  TIFR0 = 0x07;
  report(OUT_IN(TCCR0B, _BV(CS00), 5, TIFR0));
  TCCR0A = _BV(WGM01);
  report(OUT_IN(TCNT0, 0x40, 2, TCNT0));
  end_program();
}
