// ADTS 3 to 6 start a conversion by timer 0's compare match A and overflow, and timer 1's compare match B and
// overflow.
// Source: DS40002061B, 24.3, table 24-6
// Expect: 00 10 00 10 00 10 00 10
// Chips: atmega328p atmega2560 atmega32u4
// Host: not simulated: ADTS
#include "report.h"

// Timers start 100 counts before their overflow, and match 50 counts before it. A conversion takes 3 + 13.5 *
// 2 = 30 cycles.
static __attribute__((noinline)) void look(uint8_t source, uint8_t before, uint8_t behind) {
  ADCSRB = source;
  TCCR0B = TCCR1B = 0;
  TCNT0 = 156;
  TCNT1 = 65436;
  TIFR0 = 0x07;
  TIFR1 = 0x27;
  ADCSRA = _BV(ADEN) | _BV(ADATE) | _BV(ADIF);
  TCCR0B = _BV(CS00);
  TCCR1B = _BV(CS10);
  while (TCNT1 > 1000 && (uint8_t)TCNT1 < before) {
  }
  report(ADCSRA & _BV(ADIF));
  while (TCNT1 > 1000 && (uint8_t)TCNT1 < behind) {
  }
  __builtin_avr_delay_cycles(50);
  report(ADCSRA & _BV(ADIF));
}

int main(void) {
  OCR0A = 206;
  OCR1B = 65486;
  ADCSRA = _BV(ADEN) | _BV(ADSC);
  __builtin_avr_delay_cycles(100);
  look(3, 190, 206);
  look(4, 230, 255);
  look(5, 190, 206);
  look(6, 230, 255);
  end_program();
}
