// PWM edges trigger the chip's own interrupts: ten periods of fast or phase correct PWM change the pin twenty
// times each, and rise ten times.
// Source: DS40002061B, 13.1, 13.2.5, 15.7.3, 15.7.4
// Expect: 14 14 0a
// Ends: 300000
#include "report.h"

static volatile uint8_t edges;
ISR(PCINT2_vect) { ++edges; }
ISR(INT1_vect) { ++edges; }

static void wait_for_bottom(void) {
  TIFR0 = _BV(TOV0);
  while (!(TIFR0 & _BV(TOV0))) {
  }
  NOPS(40);
}

static void count(void) {
  wait_for_bottom();
  PCIFR = _BV(PCIF2);
  EIFR = _BV(INTF1);
  edges = 0;
  sei();
  for (uint8_t i = 0; i < 10; ++i) wait_for_bottom();
  report(edges);
}

int main(void) {
  DDRD = _BV(DDD3) | _BV(DDD6);
  PCMSK2 = _BV(PCINT22);
  PCICR = _BV(PCIE2);
  OCR0A = 100;
  TCCR0A = _BV(COM0A1) | _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(CS01);
  count();
  TCCR0A = _BV(COM0A1) | _BV(WGM00);
  count();
  PCICR = 0;
  TCCR0A = _BV(WGM01) | _BV(WGM00);
  OCR2B = 30;
  TCCR2A = _BV(COM2B1) | _BV(WGM21) | _BV(WGM20);
  TCCR2B = _BV(CS21);
  EICRA = _BV(ISC11) | _BV(ISC10);
  EIMSK = _BV(INT1);
  count();
  end_program();
}
