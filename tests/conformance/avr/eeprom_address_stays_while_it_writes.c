// While a byte is being written, EEAR cannot be changed and EERE reads nothing.
// Source: DS40002061B, 8.6.1, 8.6.3
// Expect: 05 33 77
// Chips: atmega328p atmega2560 atmega32u4 attiny85
#include "report.h"

int main(void) {
  EEAR = 5;
  EEDR = 0x77;
  EECR |= _BV(EEMPE);
  EECR |= _BV(EEPE);
  EEAR = 9;
  report(EEARL);
  EEDR = 0x33;
  EECR |= _BV(EERE);
  report(EEDR);
  while (EECR & _BV(EEPE)) {
  }
  EECR |= _BV(EERE);
  report(EEDR);
  end_program();
}
