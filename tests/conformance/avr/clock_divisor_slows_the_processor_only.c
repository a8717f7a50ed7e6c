// CLKPR divides the processor's clock, not the watchdog's: at half of 16 MHz, the watchdog's 16 ms take
// 128000 cycles.
// Source: DS40002061B, 9.11, 9.12.2
// Expect: 00 01
// Ends: 1000000
// Chips: atmega328p atmega2560 atmega32u4
// Host: not simulated: CLKPR
#include "report.h"

static volatile uint8_t served;
ISR(WDT_vect) { ++served; }

int main(void) {
  CLKPR = _BV(CLKPCE);
  CLKPR = 1;
  WDTCSR = _BV(WDIE);
  sei();
  __builtin_avr_delay_cycles(127900);
  report(served);
  __builtin_avr_delay_cycles(200);
  report(served);
  end_program();
}
