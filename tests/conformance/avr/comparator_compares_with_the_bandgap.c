// With ACBG, AIN1 is compared with the bandgap's 1.1 V: a low level is below it, a high level above it.
// Source: DS40002061B, 23.3.1
// Expect: 60 40
#include "report.h"

int main(void) {
  DDRD = _BV(DDD7);
  ACSR = _BV(ACBG);
  NOPS(4);
  report(ACSR & (uint8_t)~_BV(ACI));
  PORTD = _BV(PORTD7);
  NOPS(4);
  report(ACSR & (uint8_t)~_BV(ACI));
  end_program();
}
