// If MISO is connected only to its pull-up, all received bits are 1.
// Source: DS40002061B, 19.2, table 19-1
// Expect: ff
#include "report.h"

int main(void) {
  DDRB = _BV(DDB2) | _BV(DDB3) | _BV(DDB5);
  PORTB = _BV(PORTB4);
  SPCR = _BV(SPE) | _BV(MSTR);
  SPDR = 0x5A;
  while (!(SPSR & _BV(SPIF))) {
  }
  report(SPDR);
  end_program();
}
