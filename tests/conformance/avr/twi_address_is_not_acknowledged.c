// Statuses on a bus without devices: START 0x08, an address to write 0x20, a repeated START 0x10, an address
// to read 0x48.
// Source: DS40002061B, 21.7.1, tables 21-3 and 21-4
// Expect: f8 08 f8 20 10 48
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

static void step(uint8_t control) {
  TWCR = _BV(TWINT) | _BV(TWEN) | control;
  while (!(TWCR & _BV(TWINT))) {
  }
}

int main(void) {
  TWBR = 2;
  report(TWSR);
  step(_BV(TWSTA));
  report(TWSR);
  TWDR = 0x40;
  TWCR = _BV(TWINT) | _BV(TWEN);
  report(TWSR);
  while (!(TWCR & _BV(TWINT))) {
  }
  report(TWSR);
  step(_BV(TWSTA));
  report(TWSR);
  TWDR = 0x41;
  step(0);
  report(TWSR);
  end_program();
}
