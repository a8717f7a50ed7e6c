// ICR1 can be written only in modes in which it is TOP.
// Source: DS40002061B, 16.6
// Expect: 00 00 12 34
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

int main(void) {
  ICR1 = 0x5678;
  report_word(ICR1);
  TCCR1B = _BV(WGM13);
  ICR1 = 0x1234;
  report_word(ICR1);
  end_program();
}
