// Exactly one instruction after SEI runs before a pending interrupt.
// Source: DS40002061B, 7.7
// Expect: 01 f1
// Chips: atmega328p atmega2560 atmega32u4
// Host: assembler
#include "report.h"

ISR(TIMER0_OVF_vect, ISR_NAKED) {
  __asm__ volatile("ldi r24, 0xF1\n\tout %0, r24\n\tout %1, r24\n\t1: rjmp 1b" ::"I"(_SFR_IO_ADDR(GPIOR0)),
                   "I"(_SFR_IO_ADDR(GPIOR1)));
}

int main(void) {
  TCCR0B = _BV(CS00);
  TIMSK0 = _BV(TOIE0);
  TCNT0 = 0xF0;
  NOPS(40);
  __asm__ volatile("ldi r24, 1\n\tldi r25, 2\n\tsei\n\tout %0, r24\n\tout %0, r25" ::"I"(_SFR_IO_ADDR(GPIOR0)) : "r24", "r25");
  end_program();
}
