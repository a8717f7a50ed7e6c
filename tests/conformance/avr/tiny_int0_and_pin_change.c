// MCUCR selects INT0's edge; INT0 and the pin change share GIMSK and GIFR, and each interrupt clears its own
// flag.
// Source: 2586Q, 9.3.1 to 9.3.3
// Expect: 20 60 40 a1 a2 00
// Chips: attiny85
#include "report.h"

ISR(INT0_vect) { report(0xA1); }
ISR(PCINT0_vect) { report(0xA2); }

int main(void) {
  MCUCR = _BV(ISC01) | _BV(ISC00);
  PCMSK = _BV(PCINT2);
  DDRB = _BV(DDB2);
  PORTB = _BV(PB2);
  NOPS(4);
  GIFR = _BV(INTF0);
  report(GIFR);
  PORTB = 0;
  GIFR = _BV(PCIF);
  PORTB = _BV(PB2);
  NOPS(4);
  report(GIFR);
  GIFR = _BV(PCIF);
  report(GIFR);
  PORTB = 0;
  NOPS(4);
  GIMSK = _BV(INT0) | _BV(PCIE);
  sei();
  NOPS(4);
  report(GIFR);
  end_program();
}
