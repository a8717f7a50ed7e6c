// In idle mode timers keep running, and their interrupts wake the processor.
// Source: DS40002061B, 10.4
// Expect: f1 01
// Chips: atmega328p atmega2560
#include "cycles.h"

ISR(TIMER2_COMPA_vect) { report(0xF1); }

int main(void) {
  OCR2A = 100;
  TIMSK2 = _BV(OCIE2A);
  TCCR2B = _BV(CS22);
  SMCR = _BV(SE);
  sei();
  sleep_cpu();
  report(0x01);
  end_program();
}
