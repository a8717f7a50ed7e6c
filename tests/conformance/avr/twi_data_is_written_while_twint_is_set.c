// A write to TWDR while TWINT is 0 is ignored and sets TWWC; a write while TWINT is 1 clears TWWC.
// Source: DS40002061B, 21.9.2
// Expect: ff 08 55 a4
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

int main(void) {
  TWDR = 0x55;
  report(TWDR);
  report(TWCR);
  TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTA);
  while (!(TWCR & _BV(TWINT))) {
  }
  TWDR = 0x55;
  report(TWDR);
  report(TWCR);
  end_program();
}
