// An edge of ICP1 that ICES1 chooses copies TCNT1 to ICR1 three cycles later, and sets ICF1.
// Source: DS40002061B, 16.6
// Expect: 13 20 00 00 20
// Host: assembler
#include "cycles.h"

// TCNT1 is 0x10; one cycle later the pin rises.
#define RISE()                                                                                        \
  __asm__ volatile("sts %0, %1\n\tout %2, %3" ::"n"(_SFR_MEM_ADDR(TCNT1L)), "r"((uint8_t)0x10),       \
                   "I"(_SFR_IO_ADDR(PORTB)), "r"((uint8_t)_BV(PB0)))

int main(void) {
  DDRB = _BV(PB0);
  TCCR1B = _BV(ICES1) | _BV(CS10);
  TCNT1H = 0;
  RISE();
  NOPS(8);
  report(ICR1L);
  report(TIFR1 & _BV(ICF1));
  TIFR1 = _BV(ICF1);
  PORTB = 0;
  NOPS(8);
  report(TIFR1 & _BV(ICF1));
  TCCR1B = _BV(CS10);
  NOPS(8);
  TIFR1 = _BV(ICF1);
  PORTB = _BV(PB0);
  NOPS(8);
  report(TIFR1 & _BV(ICF1));
  PORTB = 0;
  NOPS(8);
  report(TIFR1 & _BV(ICF1));
  end_program();
}
