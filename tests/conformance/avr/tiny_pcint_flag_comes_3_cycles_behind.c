// A pin change passes a latch, a synchroniser and two registers: PCIF is set 3 cycles later.
// Source: 2586Q, figure 9-1
// Expect: 00 20
// Chips: attiny85
#include "report.h"

int main(void) {
  uint8_t flags;
  DDRB = _BV(DDB0);
  PCMSK = _BV(PCINT0);
  __asm__ volatile("sbi %1, 0\n\tnop\n\tin %0, %2" : "=r"(flags) : "I"(_SFR_IO_ADDR(PORTB)), "I"(_SFR_IO_ADDR(GIFR)));
  report(flags);
  NOPS(4);
  GIFR = _BV(PCIF);
  __asm__ volatile("cbi %1, 0\n\tnop\n\tnop\n\tin %0, %2"
                   : "=r"(flags)
                   : "I"(_SFR_IO_ADDR(PORTB)), "I"(_SFR_IO_ADDR(GIFR)));
  report(flags);
  end_program();
}
