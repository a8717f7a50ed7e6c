// SBI on PCIFR clears only the addressed flag.
// Source: DS40002061B, 13.2.5
// Expect: 05 04
#include "report.h"

int main(void) {
  DDRB = _BV(DDB0);
  DDRD = _BV(DDD7);
  PCMSK0 = _BV(PCINT0);
  PCMSK2 = _BV(PCINT23);
  PORTB = _BV(PORTB0);
  PORTD = _BV(PORTD7);
  NOPS(4);
  report(PCIFR);
  PCIFR |= _BV(PCIF0);  // SBI
  report(PCIFR);
  end_program();
}
