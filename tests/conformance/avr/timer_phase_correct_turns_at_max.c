// In phase correct PWM with a fixed TOP the counter turns at 0xFF.
// Source: DS40002061B, 15.7.4
// Expect: ff fe fd
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

static inline void begin(void) {
  TCCR0B = 0;
  TCCR0A = 0;
  OCR0A = 0;
  TCNT0 = 0xFE;
  TIFR0 = _BV(TOV0);
  TCCR0A = _BV(WGM00);
}

int main(void) {
  begin();
  report(OUT_IN(TCCR0B, _BV(CS00), 1, TCNT0));
  begin();
  report(OUT_IN(TCCR0B, _BV(CS00), 2, TCNT0));
  begin();
  report(OUT_IN(TCCR0B, _BV(CS00), 3, TCNT0));
  end_program();
}
