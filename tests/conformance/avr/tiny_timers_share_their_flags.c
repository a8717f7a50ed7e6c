// Timers 0 and 1 share TIFR and TIMSK: writing 1 to a flag clears only that flag, and each flag has its own
// interrupt.
// Source: 2586Q, 11.9.7, 11.9.8, 12.3.7, 12.3.8
// Expect: 54 44 04 00 a0 a1 40
// Chips: attiny85
#include "timer1.h"

ISR(TIMER0_COMPA_vect) { report(0xA0); }
ISR(TIMER1_OVF_vect) { report(0xA1); }

static void set_flags(void) {
  OCR0A = 5;
  OCR0B = OCR1B = 0xFE;
  OCR1A = 5;
  TCNT0 = 0;
  TCNT1 = 0xFC;
  TCCR0B = _BV(CS00);
  TCCR1 = _BV(CS10);
  NOPS(30);
  TCCR0B = TCCR1 = 0;
}

int main(void) {
  set_flags();
  TIFR = _BV(OCF1B);
  report(TIFR);
  TIFR = _BV(OCF0A);
  report(TIFR);
  TIFR = _BV(OCF1A);
  report(TIFR);
  TIFR = _BV(TOV1);
  report(TIFR);
  set_flags();
  TIFR = _BV(OCF1B);
  TIMSK = _BV(OCIE0A);
  sei();
  NOPS(4);
  TIMSK = _BV(TOIE1);
  NOPS(4);
  report(TIFR);
  end_program();
}
