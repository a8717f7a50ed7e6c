// COM = 1 toggles the pin at each match.
// Source: DS40002061B, 16.9.2, table 16-1
// Expect: 00 02 00 02
// Ends: 6000000
#include "cycles.h"

int main(void) {
  DDRB = _BV(PB1);
  OCR1A = 999;
  TCCR1A = _BV(COM1A0);
  TCCR1B = _BV(WGM12) | _BV(CS12) | _BV(CS10);
  for (uint8_t i = 0; i < 4; ++i) {
    TIFR1 = _BV(OCF1A);
    report(PINB & _BV(PB1));
    while (!(TIFR1 & _BV(OCF1A))) {
    }
    NOPS(4);
  }
  end_program();
}
