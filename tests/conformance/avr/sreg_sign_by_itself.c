// S is a separate bit: SES and CLS change it, and BRLT tests S, not N and V.
// Source: DS40002198B, BSET, BRLT
// Expect: 10 01 00
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: assembler
#include "report.h"

int main(void) {
  uint8_t status;
  __asm__ volatile("clr r1\n\tout %1, r1\n\tses\n\tin %0, %1\n\tclr r1" : "=r"(status) : "I"(_SFR_IO_ADDR(SREG)));
  report(status);
  __asm__ volatile("ldi %0, 0\n\tout %1, %0\n\tses\n\tbrge 1f\n\tldi %0, 1\n1:" : "=d"(status) : "I"(_SFR_IO_ADDR(SREG)));
  report(status);
  __asm__ volatile("ldi %0, 0x04\n\tout %1, %0\n\tcls\n\tldi %0, 0\n\tbrge 1f\n\tldi %0, 1\n1:" : "=d"(status) : "I"(_SFR_IO_ADDR(SREG)));
  report(status);
  end_program();
}
