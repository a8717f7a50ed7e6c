// Writing SPDR during a transfer sets WCOL and has no other effect.
// Source: DS40002061B, 19.5.2
// Expect: 40 c0 00
#include "report.h"

int main(void) {
  DDRB = _BV(DDB2) | _BV(DDB3) | _BV(DDB5);
  SPCR = _BV(SPE) | _BV(MSTR);
  SPDR = 1;
  NOPS(10);
  SPDR = 2;
  report(SPSR);
  NOPS(19);
  report(SPSR);
  (void)SPDR;
  report(SPSR);
  end_program();
}
