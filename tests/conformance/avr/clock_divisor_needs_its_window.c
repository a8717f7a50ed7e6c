// CLKPS can only be written within 4 cycles after CLKPCE alone was set. That write, or the end of the 4
// cycles, clears CLKPCE.
// Source: DS40002061B, 9.12.2
// Expect: 00 00 02 80 00
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: assembler
#include "report.h"

#define WRITE_BEHIND(nops, value)                                                               \
  __asm__ volatile("sts %0, %1\n\t.rept " #nops "\n\tnop\n\t.endr\n\tsts %0, %2" ::"n"(&CLKPR), \
                   "r"((uint8_t)_BV(CLKPCE)), "r"((uint8_t)(value)))
#define CLKPR_BEHIND(nops)                                                          \
  ({                                                                                \
    uint8_t divisor;                                                                \
    __asm__ volatile("sts %1, %2\n\t.rept " #nops "\n\tnop\n\t.endr\n\tlds %0, %1"  \
                     : "=r"(divisor)                                                \
                     : "n"(&CLKPR), "r"((uint8_t)_BV(CLKPCE)));                     \
    divisor;                                                                        \
  })

int main(void) {
  CLKPR = 1;
  report(CLKPR);
  WRITE_BEHIND(3, 2);
  report(CLKPR);
  WRITE_BEHIND(2, 2);
  report(CLKPR);
  WRITE_BEHIND(0, 0);
  report(CLKPR_BEHIND(2));
  NOPS(4);
  report(CLKPR_BEHIND(3));
  end_program();
}
