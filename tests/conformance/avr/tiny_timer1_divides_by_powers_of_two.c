// CS13 to CS10 divide timer 1's clock by 1, 2, 4 and so on to 16384; PSR1 sets its prescaler to 0, and PSR0
// does not.
// Source: 2586Q, 12.1, 12.3.2, table 12-5
// Expect: 00 01 00 01 00 01 05
// Chips: attiny85
#include "timer1.h"

int main(void) {
  TCCR1 = 7;
  report(AFTER_CYCLES(0, 50, TCNT1));
  report(AFTER_CYCLES(0, 70, TCNT1));
  TCCR1 = 10;
  report(AFTER_CYCLES(0, 500, TCNT1));
  report(AFTER_CYCLES(0, 520, TCNT1));
  TCCR1 = 15;
  report(AFTER_CYCLES(0, 16370, TCNT1));
  report(AFTER_CYCLES(0, 16390, TCNT1));
  TCCR1 = 7;
  TCNT1 = 0;
  GTCCR = _BV(PSR1);
  for (uint8_t i = 0; i < 5; ++i) {
    __builtin_avr_delay_cycles(40);
    GTCCR = _BV(PSR0);
    __builtin_avr_delay_cycles(20);
  }
  report(TCNT1);
  end_program();
}
