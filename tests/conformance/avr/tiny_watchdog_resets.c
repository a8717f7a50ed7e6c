// In reset mode the watchdog resets the chip, sets WDRF, and keeps running: WDRF keeps WDE set.
// Source: 2586Q, 8.2.4, 8.5.1, 8.5.2
// Expect: 01 09 08
// Ends: 1000000
// Chips: attiny85
#include "report.h"

int main(void) {
  report(MCUSR);
  if (MCUSR & _BV(WDRF)) {
    report(WDTCR);
    end_program();
  }
  WDTCR = _BV(WDE);
  for (;;) {
  }
}
