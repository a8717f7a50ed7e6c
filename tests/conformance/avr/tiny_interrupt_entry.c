// Entering an interrupt takes 4 cycles; the vector's RJMP takes 2 more.
// Source: 2586Q, 4.8.1
// Expect: 06
// Chips: attiny85
#include "report.h"

// Timer 0 counts cycles and overflows during the NOPs. IN returns the cycles since the overflow.
ISR(TIMER0_OVF_vect, ISR_NAKED) {
  __asm__ volatile(
      "in r24, %0\n\t"
      "out %1, r24\n\t"
      "out %2, r24\n\t"
      "1: rjmp 1b" ::"I"(_SFR_IO_ADDR(TCNT0)),
      "I"(_SFR_IO_ADDR(GPIOR0)), "I"(_SFR_IO_ADDR(GPIOR1)));
}

int main(void) {
  TCCR0B = _BV(CS00);
  TIMSK = _BV(TOIE0);
  TCNT0 = 0xF0;
  sei();
  NOPS(40);
  end_program();
}
