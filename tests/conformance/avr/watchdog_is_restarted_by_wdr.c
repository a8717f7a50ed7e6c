// WDR restarts the watchdog's timeout.
// Source: DS40002061B, 11.8
// Expect: 08 08
// Ends: 1000000
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

int main(void) {
  WDTCSR = _BV(WDE);
  __builtin_avr_delay_cycles(250000);
  wdt_reset();
  __builtin_avr_delay_cycles(250000);
  wdt_reset();
  report(WDTCSR);
  __builtin_avr_delay_cycles(255000);
  report(WDTCSR);
  end_program();
}
