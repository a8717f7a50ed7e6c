// The noise canceler delays a capture by 4 cycles, and suppresses pulses of less than 4 cycles.
// Source: DS40002061B, 16.6.2
// Expect: 17 00 20
// Host: assembler
#include "cycles.h"

// TCNT1 is 0x10; one cycle later the pin rises.
#define RISE()                                                                                        \
  __asm__ volatile("sts %0, %1\n\tout %2, %3" ::"n"(_SFR_MEM_ADDR(TCNT1L)), "r"((uint8_t)0x10),       \
                   "I"(_SFR_IO_ADDR(PORTB)), "r"((uint8_t)_BV(PB0)))

static inline void begin(void) {
  PORTB = 0;
  NOPS(20);
  TIFR1 = _BV(ICF1);
}

int main(void) {
  DDRB = _BV(PB0);
  TCCR1B = _BV(ICNC1) | _BV(ICES1) | _BV(CS10);
  TCNT1H = 0;
  RISE();
  NOPS(12);
  report(ICR1L);
  begin();
  (void)OUT_OUT_IN(PORTB, _BV(PB0), PORTB, 0, 12, PINB);
  report(TIFR1 & _BV(ICF1));
  begin();
  (void)OUT_IN(PORTB, _BV(PB0), 2, PINB);
  PORTB = 0;
  NOPS(12);
  report(TIFR1 & _BV(ICF1));
  end_program();
}
