// Without PWM, COM1A and COM1B toggle, clear and set PB1 and PB4 at the match; FOC1A does so without a match.
// Source: 2586Q, 12.2, tables 12-4 and 12-6, 12.3.2
// Expect: 00 02 00 02 12 02
// Ends: 1000000
// Chips: attiny85
#include "timer1.h"

int main(void) {
  DDRB = _BV(DDB1) | _BV(DDB4);
  OCR1C = 99;
  OCR1A = 3;
  OCR1B = 3;
  TCCR1 = _BV(CTC1) | _BV(COM1A0) | 15;
  report(AFTER_CYCLES(2, 8192L * 3, PINB));
  report(AFTER_CYCLES(2, 8192L * 5, PINB));
  report(AFTER_CYCLES(2, 8192L * 5, PINB));
  GTCCR = _BV(FOC1A);
  NOPS(2);
  report(PINB);
  GTCCR = _BV(COM1B1) | _BV(COM1B0) | _BV(FOC1B);
  NOPS(2);
  report(PINB);
  GTCCR = _BV(COM1B1) | _BV(FOC1B);
  NOPS(2);
  report(PINB);
  end_program();
}
