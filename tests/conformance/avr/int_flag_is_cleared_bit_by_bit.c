// SBI on EIFR clears only the addressed flag; CBI and writing 0 clear no flag.
// Source: DS40002061B, 13.2.3
// Expect: 03 03 03 02 00
#include "report.h"

int main(void) {
  DDRD = _BV(DDD2) | _BV(DDD3);
  EICRA = _BV(ISC00) | _BV(ISC10);
  PORTD = _BV(PORTD2) | _BV(PORTD3);
  NOPS(4);
  report(EIFR);
  EIFR = 0;
  report(EIFR);
  EIFR &= (uint8_t)~_BV(INTF0);  // CBI
  report(EIFR);
  EIFR |= _BV(INTF0);  // SBI
  report(EIFR);
  EIFR = _BV(INTF1);
  report(EIFR);
  end_program();
}
