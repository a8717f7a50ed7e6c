// A chip without AIN1 compares AIN0 with the bandgap unless the multiplexer is selected.
// Source: 7766J, 23.2, 23.3.1
// Expect: 20 00
// Chips: atmega32u4
#include "report.h"

int main(void) {
  DDRE = _BV(DDE6);
  PORTE = _BV(PORTE6);
  NOPS(4);
  report(ACSR & _BV(ACO));
  PORTE = 0;
  NOPS(4);
  report(ACSR & _BV(ACO));
  end_program();
}
