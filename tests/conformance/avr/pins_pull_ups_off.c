// PUD disables all pull-ups; outputs are unchanged.
// Source: DS40002061B, 14.2.1, 14.4.1
// Expect: 06 02 06
// Chips: atmega328p atmega2560 atmega32u4 attiny85
#include "report.h"

// PB1 is an output. PB2 is an input that is connected only to its pull-up.
int main(void) {
  DDRB = _BV(DDB1);
  PORTB = _BV(PORTB1) | _BV(PORTB2);
  NOPS(2);
  report(PINB & 0x06);
  MCUCR = _BV(PUD);
  NOPS(2);
  report(PINB & 0x06);
  MCUCR = 0;
  NOPS(2);
  report(PINB & 0x06);
  end_program();
}
