// PLOCK reads 1 once the PLL that PLLE enables has locked, within 100 us; PLOCK cannot be written.
// Source: 2586Q, 12.3.9
// Expect: 00 02 03 00
// Chips: attiny85
#include "report.h"

int main(void) {
  PLLCSR = _BV(PLOCK);
  report(PLLCSR);
  PLLCSR = _BV(PLLE);
  report(PLLCSR);
  __builtin_avr_delay_cycles(1600);
  report(PLLCSR);
  PLLCSR = 0;
  report(PLLCSR);
  end_program();
}
