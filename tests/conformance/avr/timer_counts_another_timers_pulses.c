// Timer 1 counts pulses of OC0B, which is the same pin as T1: pulses of PWM, and of a toggled pin.
// Source: DS40002061B, 14.3.3, 15.6, 17.2
// Expect: 00 64 00 32
// Ends: 300000
#include "report.h"

static void count(void) {
  TCNT1 = 0;
  TCCR1B = _BV(CS12) | _BV(CS11) | _BV(CS10);
}

static void tell(void) {
  TCCR1B = 0;
  report_word(TCNT1);
}

int main(void) {
  DDRD = _BV(DDD5);
  OCR0B = 20;
  TCCR0A = _BV(COM0B1) | _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(CS00);
  count();
  __builtin_avr_delay_cycles(25600);
  tell();
  OCR0A = 99;
  TCCR0A = _BV(COM0B0) | _BV(WGM01);
  count();
  __builtin_avr_delay_cycles(10000);
  tell();
  end_program();
}
