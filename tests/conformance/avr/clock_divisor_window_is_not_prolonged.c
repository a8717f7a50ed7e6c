// Setting CLKPCE again does not extend the window of four cycles.
// Source: DS40002061B, 9.12.2
// Expect: 00
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: assembler
#include "report.h"

// STS takes 2 cycles.
int main(void) {
  __asm__ volatile("sts %0, %1\n\tsts %0, %1\n\tnop\n\tsts %0, %2" ::"n"(&CLKPR), "r"((uint8_t)_BV(CLKPCE)),
                   "r"((uint8_t)1));
  report(CLKPR);
  end_program();
}
