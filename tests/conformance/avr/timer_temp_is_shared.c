// The 16-bit registers share one byte for the high part: it is written before the low part, and latched when
// the low part is read.
// Source: DS40002061B, 16.3
// Expect: 12 34 ff 01 02
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

int main(void) {
  TCNT1H = 0x12;
  OCR1AL = 0x34;
  report_word(OCR1A);
  TCNT1 = 0x01FF;
  report(TCNT1L);
  TCCR1B = _BV(CS10);
  NOPS(10);
  report(TCNT1H);
  (void)TCNT1L;
  report(TCNT1H);
  end_program();
}
