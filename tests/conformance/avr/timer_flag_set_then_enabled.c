// A flag that was set before its interrupt was enabled is served once the interrupt is enabled; entering the
// vector clears the flag.
// Source: DS40002061B, 15.9.7
// Expect: f1 00
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

ISR(TIMER0_OVF_vect) { report(0xF1); }

int main(void) {
  sei();
  TCNT0 = 0xF0;
  TCCR0B = _BV(CS00);
  NOPS(30);
  TCCR0B = 0;
  TIMSK0 = _BV(TOIE0);
  NOPS(10);
  report(TIFR0 & _BV(TOV0));
  end_program();
}
