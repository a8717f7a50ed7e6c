// Entering an interrupt takes 4 cycles; the vector's JMP takes 3 more.
// Source: DS40002061B, 7.7.1
// Expect: 07 00
// Host: assembler
#include "report.h"

// Timer 0 runs at the processor's clock and overflows during a row of NOPs. The handler reads the timer
// immediately. IN returns the cycles since the overflow: 4 for the entry and 3 for the JMP.
ISR(TIMER0_OVF_vect, ISR_NAKED) {
  __asm__ volatile(
      "in r24, %0\n\t"
      "out %1, r24\n\t"
      "ldi r24, 0\n\t"
      "out %1, r24\n\t"
      "out %2, r24\n\t"
      "1: rjmp 1b" ::"I"(_SFR_IO_ADDR(TCNT0)),
      "I"(_SFR_IO_ADDR(GPIOR0)), "I"(_SFR_IO_ADDR(GPIOR1)));
}

int main(void) {
  TCCR0B = _BV(CS00);
  TIMSK0 = _BV(TOIE0);
  TCNT0 = 0xF0;
  sei();
  NOPS(40);
  end_program();
}
