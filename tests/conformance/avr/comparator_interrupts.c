// ACI with ACIE requests an interrupt; entering the vector clears ACI.
// Source: DS40002061B, 23.3.1
// Expect: 01 2b
#include "report.h"

static volatile uint8_t served;
ISR(ANALOG_COMP_vect) { ++served; }

int main(void) {
  DDRD = _BV(DDD6);
  ACSR = _BV(ACIE) | _BV(ACIS1) | _BV(ACIS0);
  sei();
  PORTD = _BV(PORTD6);
  __builtin_avr_delay_cycles(200);
  report(served);
  report(ACSR);
  end_program();
}
