// In TIFR1 and TIFR2, too, writing 1 by OUT or SBI clears only that flag; writing 0 clears no flag.
// Source: DS40002061B, 16.11.9, 18.11.7
// Expect: 07 07 05 04 00 07 07 05 04 00
#include "report.h"

#define CLEARS(flags)                                                    \
  do {                                                                   \
    report(flags & 7);                                                   \
    flags = 0;                                                           \
    report(flags & 7);                                                   \
    flags = _BV(1);                                                      \
    report(flags & 7);                                                   \
    flags |= _BV(0); /* SBI */                                           \
    report(flags & 7);                                                   \
    flags = _BV(2);                                                      \
    report(flags & 7);                                                   \
  } while (0)

int main(void) {
  TCNT1 = 0xFFF0;
  OCR1A = OCR1B = 0xFFF8;
  TCCR1B = _BV(CS10);
  NOPS(50);
  TCCR1B = 0;
  CLEARS(TIFR1);
  TCNT2 = 0xF0;
  OCR2A = OCR2B = 0xF8;
  TCCR2B = _BV(CS20);
  NOPS(50);
  TCCR2B = 0;
  CLEARS(TIFR2);
  end_program();
}
