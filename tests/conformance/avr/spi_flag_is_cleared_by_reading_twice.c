// SPIF is cleared by reading SPSR and then accessing SPDR. Accessing only SPDR, or writing SPSR, leaves SPIF
// set.
// Source: DS40002061B, 19.5.2
// Expect: 80 80 00
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

int main(void) {
  DDRB = _BV(DDB2) | _BV(DDB3) | _BV(DDB5);
  SPCR = _BV(SPE) | _BV(MSTR);
  SPDR = 1;
  NOPS(40);
  (void)SPDR;
  SPSR = 0;
  report(SPSR);
  report(SPSR);
  (void)SPDR;
  report(SPSR);
  end_program();
}
