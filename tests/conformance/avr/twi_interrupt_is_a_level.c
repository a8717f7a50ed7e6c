// TWINT requests its interrupt as long as it is set: entering the vector does not clear it.
// Source: DS40002061B, 21.6, 21.9.2
// Expect: 03 84
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

static volatile uint8_t served;
ISR(TWI_vect) {
  if (++served == 3) TWCR = _BV(TWEN);
}

int main(void) {
  sei();
  TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTA) | _BV(TWIE);
  __builtin_avr_delay_cycles(500);
  report(served);
  report(TWCR);
  end_program();
}
