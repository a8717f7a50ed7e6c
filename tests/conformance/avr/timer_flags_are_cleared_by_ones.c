// Writing 1 to a flag clears it; SBI clears only that flag.
// Source: DS40002061B, 15.9.7
// Expect: 07 05 04 04
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

int main(void) {
  TCCR0B = _BV(CS00);
  NOPS(300);
  TCCR0B = 0;
  report(TIFR0);
  TIFR0 = _BV(OCF0A);
  report(TIFR0);
  TIFR0 |= _BV(TOV0);  // SBI
  report(TIFR0);
  TIFR0 &= (uint8_t)~_BV(OCF0B);  // CBI
  report(TIFR0);
  end_program();
}
