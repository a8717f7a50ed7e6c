// A pin change that occurs before PCICR enables its group is remembered, and served once the group is
// enabled; entering the vector clears the flag.
// Source: DS40002061B, 13.2.4, 13.2.5
// Expect: 00 02 01 00
#include "report.h"

static volatile uint8_t served;
ISR(PCINT1_vect) { ++served; }

int main(void) {
  DDRC = _BV(DDC3);
  PCMSK1 = _BV(PCINT11);
  sei();
  PORTC = _BV(PORTC3);
  NOPS(4);
  report(served);
  report(PCIFR);
  PCICR = _BV(PCIE1);
  NOPS(4);
  report(served);
  report(PCIFR);
  end_program();
}
