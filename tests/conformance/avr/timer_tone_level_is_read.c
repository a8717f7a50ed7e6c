// PINx reads the level of a pin that toggles at an audible rate, and both of the pin's edges are pin changes.
// Source: DS40002061B, 13.1, 14.2.4, 16.9.2
// Expect: 00 02 00 02 14
// Ends: 400000
#include "report.h"

static volatile uint8_t edges;
ISR(PCINT0_vect) { ++edges; }

int main(void) {
  DDRB = _BV(DDB1);
  OCR1A = 7999;
  TCCR1A = _BV(COM1A0);
  TCCR1B = _BV(WGM12) | _BV(CS10);
  __builtin_avr_delay_cycles(4000);
  for (uint8_t i = 0; i < 4; ++i) {
    report(PINB & _BV(PB1));
    __builtin_avr_delay_cycles(8000);
  }
  PCMSK0 = _BV(PCINT1);
  PCICR = _BV(PCIE0);
  PCIFR = _BV(PCIF0);
  sei();
  __builtin_avr_delay_cycles(160000 - 20 * 40);
  report(edges);
  end_program();
}
