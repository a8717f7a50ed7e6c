// A timer whose prescaler changes while it runs continues from its count.
// Source: DS40002061B, 16.4, 17.1
// Expect: 12 34 12 34 12 35
#include "report.h"

int main(void) {
  TCCR1B = _BV(CS12);
  TCNT1 = 0x1234;
  TCCR1B = _BV(CS12) | _BV(CS10);
  NOPS(20);
  report_word(TCNT1);
  GTCCR = _BV(PSRSYNC);
  TCCR1B = _BV(CS11) | _BV(CS10);
  NOPS(20);
  report_word(TCNT1);
  NOPS(40);
  report_word(TCNT1);
  end_program();
}
