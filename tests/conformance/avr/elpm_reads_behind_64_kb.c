// ELPM reads at the address in RAMPZ and Z, and increments both; LPM reads the first 64 KB regardless of
// RAMPZ.
// Source: DS40002198B, ELPM, LPM
// Expect: a5 5a 02 00 00 0d
// Chips: atmega2560
#include "report.h"

// The section starts at 0x10000, so that the two bytes are at 0x1FFFF and 0x20000.
__asm__(
    ".section .progmem.far,\"a\",@progbits\n\t.balign 0x10000\n\t.skip 0xFFFF\n\t.byte 0xA5, 0x5A\n\t.byte "
    "0xFF\n\t"
    ".text\n\t");

int main(void) {
  uint8_t first, second, page, opcode;
  uint16_t z = 0xFFFF, begin = 0;
  RAMPZ = 1;
  __asm__ volatile("elpm %0, Z+\n\telpm %1, Z\n\tin %2, %4"
                   : "=&r"(first), "=&r"(second), "=&r"(page), "+z"(z)
                   : "I"(_SFR_IO_ADDR(RAMPZ)));
  report(first);
  report(second);
  report(page);
  report_word(z);
  __asm__ volatile("lpm %0, Z" : "=r"(opcode) : "z"(begin));
  report(opcode);  // the low byte of the JMP at address 0, whose target is above 128 KB
  end_program();
}
