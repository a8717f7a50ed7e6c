// Both edges of the pins that PCMSK selects set their group's flag, even without PCICR; other pins do not.
// Source: DS40002061B, 13.2.5 to 13.2.8
// Expect: 01 01 00 04
#include "report.h"

static void look(void) {
  NOPS(4);
  report(PCIFR);
  PCIFR = 0x07;
}

int main(void) {
  DDRB = _BV(DDB0) | _BV(DDB1);
  DDRD = _BV(DDD7);
  PCMSK0 = _BV(PCINT0);
  PCMSK2 = _BV(PCINT23);
  PORTB = _BV(PORTB0);
  look();
  PORTB = 0;
  look();
  PORTB = _BV(PORTB1);
  look();
  PORTD = _BV(PORTD7);
  look();
  end_program();
}
