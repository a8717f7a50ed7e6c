// With TCNT1 = 65536 - 15625 and a prescaler of 64, timer 1 overflows after 1,000,000 cycles: 976 ticks of
// 1024.
// Source: DS40002061B, 16.4
// Expect: d0
// Ends: 1100000
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

int main(void) {
  GTCCR = _BV(PSRSYNC);
  TCNT0 = 0;
  TCCR0B = _BV(CS02) | _BV(CS00);
  TCNT1 = 65536 - 15625;
  TCCR1B = _BV(CS11) | _BV(CS10);
  while (!(TIFR1 & _BV(TOV1))) {
  }
  report(TCNT0);
  end_program();
}
