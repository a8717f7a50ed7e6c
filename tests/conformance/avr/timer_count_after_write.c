// One cycle after a write to TCNT0, a read returns the written value; each further cycle adds 1.
// Source: DS40002061B, 15.5.3
// Expect: 30 31 32 39
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: cycles
#include "cycles.h"

int main(void) {
  TCCR0B = _BV(CS00);
  report(OUT_IN(TCNT0, 0x30, 0, TCNT0));
  report(OUT_IN(TCNT0, 0x30, 1, TCNT0));
  report(OUT_IN(TCNT0, 0x30, 2, TCNT0));
  report(OUT_IN(TCNT0, 0x30, 9, TCNT0));
  end_program();
}
