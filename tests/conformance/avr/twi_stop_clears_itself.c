// TWSTO reads 0 once STOP is sent. STOP does not set TWINT, and the next START is not a repeated START.
// Source: DS40002061B, 21.9.2
// Expect: 14 04 f8 08
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

int main(void) {
  TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTA);
  while (!(TWCR & _BV(TWINT))) {
  }
  TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTO);
  report(TWCR);
  NOPS(20);
  report(TWCR);
  report(TWSR);
  TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTA);
  while (!(TWCR & _BV(TWINT))) {
  }
  report(TWSR);
  end_program();
}
