// With WDE and WDIE, the first timeout interrupts and clears WDIE; the second timeout resets.
// Source: DS40002061B, 11.9.2, table 11-1
// Expect: 01 48 08 09
// Ends: 2000000
// Chips: atmega328p atmega2560 atmega32u4
// Host: boot loader
#include "report.h"

ISR(WDT_vect) { report(WDTCSR); }

int main(void) {
  report(MCUSR);
  if (MCUSR & _BV(WDRF)) end_program();
  WDTCSR = _BV(WDE) | _BV(WDIE);
  report(WDTCSR);
  sei();
  for (;;) {
  }
}
