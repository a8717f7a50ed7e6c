// An instruction of two cycles reads TCNT0 in its second cycle.
// Source: DS40002061B, 15.5.3
// Expect: 02
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: assembler
#include "cycles.h"

int main(void) {
  uint8_t found;
  TCCR0B = _BV(CS00);
  __asm__ volatile("out %1, __zero_reg__\n\tnop\n\tlds %0, %2"
                   : "=r"(found)
                   : "I"(_SFR_IO_ADDR(TCNT0)), "n"(_SFR_MEM_ADDR(TCNT0)));
  report(found);
  end_program();
}
