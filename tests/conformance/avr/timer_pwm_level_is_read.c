// PINx reads the current level of a PWM pin: high from BOTTOM, and low after the match with OCR0A. A new
// OCR0A takes effect at BOTTOM.
// Source: DS40002061B, 14.2.4, 15.7.3
// Expect: 40 40 00 40 00 00
// Ends: 200000
#include "report.h"

static void at(uint8_t count) {
  while (TCNT0 != count) {
  }
  report(PIND & _BV(PD6));
}

int main(void) {
  DDRD = _BV(DDD6);
  TCCR0A = _BV(COM0A1) | _BV(WGM01) | _BV(WGM00);
  OCR0A = 200;
  TCNT0 = 250;
  TCCR0B = _BV(CS01) | _BV(CS00);
  at(50);
  OCR0A = 100;
  at(150);
  at(220);
  at(50);
  at(150);
  at(220);
  end_program();
}
