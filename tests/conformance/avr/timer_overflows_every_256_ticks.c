// With a prescaler of 64, timer 0 overflows every 16384 cycles: 100 times while timer 1 counts 25700 ticks of
// that prescaler.
// Source: DS40002061B, 15.7.1
// Expect: 64
// Ends: 2000000
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

static volatile uint8_t overflows;
ISR(TIMER0_OVF_vect) { ++overflows; }

int main(void) {
  TIMSK0 = _BV(TOIE0);
  GTCCR = _BV(PSRSYNC);
  OCR1A = 25700;
  TCCR0B = _BV(CS01) | _BV(CS00);
  TCCR1B = _BV(WGM12) | _BV(CS11) | _BV(CS10);
  sei();
  while (!(TIFR1 & _BV(OCF1A))) {
  }
  report(overflows);
  end_program();
}
