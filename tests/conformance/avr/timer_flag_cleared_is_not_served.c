// A flag that is cleared before interrupts are enabled is not served.
// Source: DS40002061B, 15.9.7
// Expect: 01
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

ISR(TIMER0_OVF_vect) { report(0xF1); }

int main(void) {
  TIMSK0 = _BV(TOIE0);
  TCNT0 = 0xF0;
  TCCR0B = _BV(CS00);
  NOPS(30);
  TCCR0B = 0;
  TIFR0 = _BV(TOV0);
  sei();
  NOPS(10);
  report(0x01);
  end_program();
}
