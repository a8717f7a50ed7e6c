// Fast PWM of 10 bits goes from 0x3FF to 0, and overflows there.
// Source: DS40002061B, 16.9.3
// Expect: ff 00 00 01
// Chips: atmega328p atmega2560 atmega32u4
// Host: cycles
#include "cycles.h"

int main(void) {
  TCCR1A = _BV(WGM11) | _BV(WGM10);
  TCCR1B = _BV(WGM12) | _BV(CS10);
  TCNT1H = 0x03;
  report(STS_LDS(TCNT1L, 0xFE, 0, TCNT1L));
  TCNT1H = 0x03;
  report(STS_LDS(TCNT1L, 0xFE, 1, TCNT1L));
  TCNT1 = 0x10;
  TIFR1 = _BV(TOV1);
  report(TIFR1 & _BV(TOV1));
  TCNT1 = 0x3F0;
  NOPS(20);
  report(TIFR1 & _BV(TOV1));
  end_program();
}
