// In power-down timers stop; the watchdog wakes the chip after 256000 cycles, of which timer 1 counts only a
// few.
// Source: DS40002061B, 10.3, table 10-1
// Expect: 01
// Ends: 2000000
// Chips: atmega328p atmega2560 atmega32u4
// Host: not simulated: sleep modes other than idle
#include "cycles.h"

ISR(WDT_vect) {}

int main(void) {
  uint16_t count;
  cli();
  WDTCSR = _BV(WDCE) | _BV(WDE);
  WDTCSR = _BV(WDIE);
  SMCR = _BV(SM1) | _BV(SE);
  TCCR1B = _BV(CS11) | _BV(CS10);
  TCNT1 = 0;
  sei();
  sleep_cpu();
  count = TCNT1;
  report(count < 300);
  end_program();
}
