// SS as an input at low level clears MSTR and sets SPIF; as an output, SS has no effect.
// Source: DS40002061B, 19.3.2
// Expect: 50 00 40 80
#include "report.h"

int main(void) {
  DDRB = _BV(DDB2);
  SPCR = _BV(SPE) | _BV(MSTR);
  report(SPCR);
  report(SPSR);
  SPCR = 0;
  DDRB = 0;
  SPCR = _BV(SPE) | _BV(MSTR);
  report(SPCR);
  report(SPSR);
  end_program();
}
