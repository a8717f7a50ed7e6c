// SE and SM are in MCUCR. In power-down timers stop; the watchdog wakes the chip, 4 cycles after the
// oscillator's start.
// Source: 2586Q, 7.1, 7.5.1, 8.5.2
// Expect: 05 0b
// Ends: 1000000
// Chips: attiny85
#include "report.h"

// The timer counts SLEEP, 4 cycles to wake up, 4 cycles of interrupt entry, and the vector's RJMP.
ISR(WDT_vect, ISR_NAKED) {
  __asm__ volatile(
      "in r24, %0\n\t"
      "out %1, r24\n\t"
      "out %2, r24\n\t"
      "1: rjmp 1b" ::"I"(_SFR_IO_ADDR(TCNT0)),
      "I"(_SFR_IO_ADDR(GPIOR0)), "I"(_SFR_IO_ADDR(GPIOR1)));
}

int main(void) {
  WDTCR = _BV(WDIE);
  sei();
  MCUCR = _BV(SM1);
  sleep_cpu();
  report(5);
  MCUCR = _BV(SM1) | _BV(SE);
  TCCR0B = _BV(CS00);
  __asm__ volatile("out %0, %1\n\tsleep" ::"I"(_SFR_IO_ADDR(TCNT0)), "r"((uint8_t)0));
  report(6);
  end_program();
}
