// OCR1C matches as OCR1A and OCR1B do, sets OCF1C, and has its own vector between OCR1B's and the overflow's.
// Source: 2549Q, 17.7, 17.11.36, table 14-1
// Expect: 00 08 c1 00 01
// Chips: atmega2560 atmega32u4
#include "cycles.h"

static volatile uint8_t served;
ISR(TIMER1_COMPC_vect) { served = 0xC1; }
ISR(TIMER1_OVF_vect) { served = 0x0F; }

int main(void) {
  OCR1A = OCR1B = 0x1000;
  OCR1C = 100;
  TCCR1B = _BV(CS10);
  TCNT1 = 50;
  report(TIFR1 & _BV(OCF1C));
  NOPS(60);
  report(TIFR1);
  TIMSK1 = _BV(OCIE1C);
  sei();
  NOPS(4);
  report(served);
  report(TIFR1 & _BV(OCF1C));
  cli();
  TCCR1A = _BV(COM1C0);  // toggles at a match, which is forced here
  TCCR1C = _BV(FOC1C);
  report(1);
  end_program();
}
