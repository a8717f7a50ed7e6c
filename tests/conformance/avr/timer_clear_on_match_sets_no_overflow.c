// With clear on match by OCR1A, ICR1 or OCR2A, a timer sets the match's flag at each match, and never TOV.
// Source: DS40002061B, 15.9.7, 16.9.2, 18.7.2
// Expect: 02 02 20 02 02
#include "report.h"

int main(void) {
  OCR1A = 99;
  TCCR1B = _BV(WGM12) | _BV(CS10);
  for (uint8_t i = 0; i < 2; ++i) {
    __builtin_avr_delay_cycles(250);
    report(TIFR1 & (_BV(ICF1) | _BV(OCF1A) | _BV(TOV1)));
    TIFR1 = _BV(OCF1A);
  }
  TCCR1B = _BV(WGM13) | _BV(WGM12);
  TCNT1 = 0;
  ICR1 = 99;
  OCR1A = 1000;
  TIFR1 = 0xFF;
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS10);
  __builtin_avr_delay_cycles(250);
  report(TIFR1 & (_BV(ICF1) | _BV(OCF1A) | _BV(TOV1)));
  OCR2A = 99;
  TCCR2A = _BV(WGM21);
  TCCR2B = _BV(CS20);
  for (uint8_t i = 0; i < 2; ++i) {
    __builtin_avr_delay_cycles(250);
    report(TIFR2 & (_BV(OCF2A) | _BV(TOV2)));
    TIFR2 = _BV(OCF2A);
  }
  end_program();
}
