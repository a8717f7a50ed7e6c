// INTF0 is cleared when INT0 becomes a level interrupt, and stays 0.
// Source: DS40002061B, 13.2.3
// Expect: 01 00 00
#include "report.h"

int main(void) {
  DDRD = _BV(DDD2);
  EICRA = _BV(ISC00);
  PORTD = _BV(PORTD2);
  NOPS(4);
  report(EIFR);
  EICRA = 0;
  report(EIFR);
  PORTD = 0;
  NOPS(4);
  report(EIFR);
  end_program();
}
