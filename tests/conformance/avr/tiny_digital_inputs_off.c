// DIDR0 has one bit for each pin of port B, in the port's order: a pin whose bit is set reads 0.
// Source: 2586Q, 16.2.2, 17.13.5
// Expect: 3f 0f 30 3f
// Chips: attiny85
#include "report.h"

int main(void) {
  PORTB = 0x3F;
  NOPS(2);
  report(PINB);
  DIDR0 = 0x30;
  report(PINB);
  DIDR0 = 0x0F;
  report(PINB);
  DIDR0 = 0;
  report(PINB);
  end_program();
}
