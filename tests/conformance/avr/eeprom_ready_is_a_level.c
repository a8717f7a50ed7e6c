// EE_READY is requested repeatedly while EERIE is set and no byte is being written.
// Source: DS40002061B, 8.6.3
// Expect: 00 02
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

static volatile uint8_t served;
ISR(EE_READY_vect) {
  if (++served == 2) EECR = 0;
}

int main(void) {
  EECR |= _BV(EEMPE);
  EECR |= _BV(EEPE);
  EECR |= _BV(EERIE);
  sei();
  __builtin_avr_delay_cycles(54000);
  report(served);
  __builtin_avr_delay_cycles(1000);
  report(served);
  end_program();
}
