// In interrupt mode the watchdog interrupts every 2048 cycles of 128 kHz (16 ms), and never resets.
// Source: DS40002061B, 11.9.2, tables 11-1 and 11-2
// Expect: 00 01 03 40
// Ends: 1000000
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

static volatile uint8_t served;
ISR(WDT_vect) { ++served; }

int main(void) {
  WDTCSR = _BV(WDIE);
  sei();
  __builtin_avr_delay_cycles(255900);
  report(served);
  __builtin_avr_delay_cycles(200);
  report(served);
  __builtin_avr_delay_cycles(512000);
  report(served);
  report(WDTCSR);
  end_program();
}
