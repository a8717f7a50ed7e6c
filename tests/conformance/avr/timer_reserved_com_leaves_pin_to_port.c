// In fast PWM COM0B = 1 is reserved, and so is COM0A = 1 with a fixed TOP: the port controls the pins.
// Source: DS40002061B, tables 15-3, 15-6
// Expect: 60 00
// Chips: atmega328p atmega2560 atmega32u4
#include "cycles.h"

int main(void) {
  DDRD = _BV(PD5) | _BV(PD6);
  PORTD = _BV(PD5) | _BV(PD6);
  TCCR0A = _BV(COM0A0) | _BV(COM0B0) | _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(CS00);
  NOPS(10);
  report(PIND & 0x60);
  PORTD = 0;
  NOPS(10);
  report(PIND & 0x60);
  end_program();
}
