// TXC stays set until 1 is written to it; writing 0 leaves it set.
// Source: DS40002061B, 20.11.2
// Expect: 60 60 20
// Chips: atmega328p atmega2560
#include "report.h"

int main(void) {
  UCSR0B = _BV(TXEN0);
  UDR0 = 0;
  __builtin_avr_delay_cycles(200);
  report(UCSR0A);
  UCSR0A = 0;
  report(UCSR0A);
  UCSR0A = _BV(TXC0);
  report(UCSR0A);
  end_program();
}
