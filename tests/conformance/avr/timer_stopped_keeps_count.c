// A stopped timer keeps its count, and continues from it with any prescaler.
// Source: DS40002061B, 15.4
// Expect: 22 22 25 25
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

int main(void) {
  TCNT0 = 0x21;
  report(OUT_OUT_IN(TCCR0B, _BV(CS00), TCCR0B, 0, 0, TCNT0));
  NOPS(50);
  report(TCNT0);
  report(OUT_IN(TCCR0B, _BV(CS00), 3, TCNT0));
  TCCR0B = 0;
  TCNT0 = 0x25;
  GTCCR = _BV(PSRSYNC);
  TCCR0B = _BV(CS02) | _BV(CS00);
  NOPS(50);
  report(TCNT0);
  end_program();
}
