// In interrupt mode the watchdog interrupts every 2048 cycles of 128 kHz (16 ms), and never resets.
// Source: 2586Q, 8.5.2, tables 8-2 and 8-3
// Expect: 00 01 03 40
// Ends: 1000000
// Chips: attiny85
#include "report.h"

static volatile uint8_t served;
ISR(WDT_vect) { ++served; }

int main(void) {
  WDTCR = _BV(WDIE);
  sei();
  __builtin_avr_delay_cycles(255900);
  report(served);
  __builtin_avr_delay_cycles(200);
  report(served);
  __builtin_avr_delay_cycles(512000);
  report(served);
  report(WDTCR);
  end_program();
}
