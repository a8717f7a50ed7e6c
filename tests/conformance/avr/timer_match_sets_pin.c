// Without PWM, COM = 3 sets the pin at the match and not earlier; COM = 2 clears it.
// Source: DS40002061B, 15.6.2, table 15-2
// Expect: 00 40 40 00
#include "cycles.h"

static inline void begin(uint8_t com) {
  TCCR0B = 0;
  TCCR0A = (5 - com) << COM0A0;
  TCCR0B = _BV(FOC0A);
  TCCR0A = com << COM0A0;
  TCCR0B = _BV(CS00);
}

int main(void) {
  DDRD = _BV(PD6);
  OCR0A = 0x20;
  begin(3);
  report(OUT_IN(TCNT0, 0x1E, 2, PIND) & _BV(PD6));
  begin(3);
  report(OUT_IN(TCNT0, 0x1E, 6, PIND) & _BV(PD6));
  begin(2);
  report(OUT_IN(TCNT0, 0x1E, 2, PIND) & _BV(PD6));
  begin(2);
  report(OUT_IN(TCNT0, 0x1E, 6, PIND) & _BV(PD6));
  end_program();
}
