// A pin change passes a latch, a synchroniser and two registers: PCIF is set 3 cycles later.
// Source: DS40002061B, figure 13-1
// Expect: 00 01
// Chips: atmega328p atmega2560 atmega32u4
// Host: assembler
#include "report.h"

int main(void) {
  uint8_t flags;
  DDRB = _BV(DDB0);
  PCMSK0 = _BV(PCINT0);
  __asm__ volatile("sbi %1, 0\n\tnop\n\tin %0, %2" : "=r"(flags) : "I"(_SFR_IO_ADDR(PORTB)), "I"(_SFR_IO_ADDR(PCIFR)));
  report(flags);
  PCIFR = _BV(PCIF0);
  NOPS(4);
  PCIFR = _BV(PCIF0);
  __asm__ volatile("cbi %1, 0\n\tnop\n\tnop\n\tin %0, %2"
                   : "=r"(flags)
                   : "I"(_SFR_IO_ADDR(PORTB)), "I"(_SFR_IO_ADDR(PCIFR)));
  report(flags);
  end_program();
}
