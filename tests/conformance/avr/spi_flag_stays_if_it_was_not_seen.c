// SPIF stays set if it was set between the read of SPSR and the access to SPDR.
// Source: DS40002061B, 19.5.2
// Expect: 00 80
#include "report.h"

int main(void) {
  DDRB = _BV(DDB2) | _BV(DDB3) | _BV(DDB5);
  SPCR = _BV(SPE) | _BV(MSTR);
  SPDR = 1;
  report(SPSR);
  NOPS(40);
  (void)SPDR;
  report(SPSR);
  end_program();
}
