// A third byte waits in the receiver's shift register; a fourth byte replaces it, and DOR is set until UDR is
// read.
// Source: DS40002061B, 20.7.3, 20.7.4, 20.11.2
// Expect: 80 01 02 03 00 88 01 80 02 04 00
// Loop: 0
// Chips: atmega328p atmega2560
#include "report.h"

#define STATUS (UCSR0A & (_BV(RXC0) | _BV(DOR0)))

// A frame takes 160 cycles.
static void send(uint8_t count) {
  for (uint8_t byte = 1; byte <= count; ++byte) {
    UDR0 = byte;
    __builtin_avr_delay_cycles(200);
  }
}

int main(void) {
  UCSR0B = _BV(RXEN0) | _BV(TXEN0);
  send(3);
  report(STATUS);
  report(UDR0);
  report(UDR0);
  report(UDR0);
  report(STATUS);
  send(4);
  report(STATUS);
  report(UDR0);
  report(STATUS);
  report(UDR0);
  report(UDR0);
  report(STATUS);
  end_program();
}
