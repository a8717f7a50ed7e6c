// Reading OCR1A does not use the temporary byte.
// Source: DS40002061B, 16.3
// Expect: 12 56
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

int main(void) {
  OCR1A = 0x1234;
  TCNT1 = 0x5600;
  (void)TCNT1L;
  (void)OCR1AL;
  report(OCR1AH);
  report(TCNT1H);
  end_program();
}
