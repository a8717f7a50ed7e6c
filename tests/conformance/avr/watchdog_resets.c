// In reset mode the watchdog resets the chip, sets WDRF, and keeps running: WDRF keeps WDE set.
// Source: DS40002061B, 11.5, 11.9.1, 11.9.2
// Expect: 01 09 08
// Ends: 1000000
// Chips: atmega328p atmega2560 atmega32u4
// Host: boot loader
#include "report.h"

int main(void) {
  report(MCUSR);
  if (MCUSR & _BV(WDRF)) {
    report(WDTCSR);
    end_program();
  }
  WDTCSR = _BV(WDE);
  for (;;) {
  }
}
