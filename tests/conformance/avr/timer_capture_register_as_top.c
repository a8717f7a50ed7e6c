// ICR1 as TOP is not buffered: if it is lowered below TCNT1, the counter runs past it. ICF1 is set at TOP.
// Source: DS40002061B, 16.9.3
// Expect: 01 01 20
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

int main(void) {
  TCCR1A = _BV(WGM11);
  TCCR1B = _BV(WGM13) | _BV(WGM12);
  ICR1 = 0x100;
  TCNT1 = 0x80;
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS10);
  ICR1 = 0x40;
  NOPS(200);
  report(TCNT1 > 0x100);
  TCNT1 = 0x10;
  TIFR1 = _BV(ICF1);
  NOPS(200);
  report(TCNT1 <= 0x40);
  report(TIFR1 & _BV(ICF1));
  end_program();
}
