// With WDE and WDIE, the second timeout resets even if the interrupt was not entered.
// Source: DS40002061B, 11.9.2
// Expect: 01 c8 09
// Ends: 2000000
// Chips: atmega328p atmega2560 atmega32u4
// Host: boot loader
#include "report.h"

int main(void) {
  report(MCUSR);
  if (MCUSR & _BV(WDRF)) end_program();
  WDTCSR = _BV(WDE) | _BV(WDIE);
  __builtin_avr_delay_cycles(300000);
  report(WDTCSR);
  for (;;) {
  }
}
