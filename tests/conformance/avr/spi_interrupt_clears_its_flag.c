// If SPIF is set before SPIE, setting SPIE requests the interrupt; entering the vector clears SPIF.
// Source: DS40002061B, 19.5.2
// Expect: 01 00
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

static volatile uint8_t served;
ISR(SPI_STC_vect) { ++served; }

int main(void) {
  DDRB = _BV(DDB2) | _BV(DDB3) | _BV(DDB5);
  sei();
  SPCR = _BV(SPE) | _BV(MSTR);
  SPDR = 1;
  NOPS(40);
  SPCR = _BV(SPE) | _BV(MSTR) | _BV(SPIE);
  NOPS(4);
  report(served);
  report(SPSR);
  end_program();
}
