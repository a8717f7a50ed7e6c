// A pin reads 0 if DIDR0 or DIDR1 disables its digital input.
// Source: DS40002061B, 23.3.2, 24.9.5
// Expect: 0c 08 c0 80
#include "report.h"

int main(void) {
  PORTC = _BV(PORTC2) | _BV(PORTC3);
  NOPS(2);
  report(PINC);
  DIDR0 = _BV(ADC2D);
  report(PINC);
  PORTC = 0;
  PORTD = _BV(PORTD6) | _BV(PORTD7);
  NOPS(2);
  report(PIND);
  DIDR1 = _BV(AIN0D);
  report(PIND);
  end_program();
}
