// With ACIC, an edge of ACO that ICES1 selects copies TCNT1 to ICR1. An edge of ICP1 then captures nothing.
// Source: DS40002061B, 16.6.1, 23.3.1
// Expect: 13 20 00 20
// Host: assembler
#include "cycles.h"

// TCNT1 is 0x10; one cycle later AIN0 rises above AIN1.
#define RISE()                                                                                        \
  __asm__ volatile("sts %0, %1\n\tout %2, %3" ::"n"(_SFR_MEM_ADDR(TCNT1L)), "r"((uint8_t)0x10),       \
                   "I"(_SFR_IO_ADDR(PORTD)), "r"((uint8_t)_BV(PD6)))

int main(void) {
  DDRB = _BV(PB0);
  DDRD = _BV(PD6);
  ACSR = _BV(ACIC);
  TCCR1B = _BV(ICES1) | _BV(CS10);
  TCNT1H = 0;
  RISE();
  NOPS(8);
  report(ICR1L);
  report(TIFR1 & _BV(ICF1));
  TIFR1 = _BV(ICF1);
  PORTB = _BV(PB0);
  NOPS(8);
  report(TIFR1 & _BV(ICF1));
  ACSR = 0;
  PORTB = 0;
  NOPS(8);
  TIFR1 = _BV(ICF1);
  PORTB = _BV(PB0);
  NOPS(8);
  report(TIFR1 & _BV(ICF1));
  end_program();
}
