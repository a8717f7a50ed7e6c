// PRTIM0 stops timer 0 at its count; while it is set, the timer's registers read 0 and ignore writes.
// Source: DS40002061B, 10.10, 10.11.3
// Expect: 12 00 05
// Chips: atmega328p attiny85
// Host: assembler
#include "cycles.h"

int main(void) {
  uint8_t found;
  TCCR0B = _BV(CS00);
  __asm__ volatile(
      "out %[count], %[start]\n\tsts %[power], %[off]\n\t.rept 20\n\tnop\n\t.endr\n\t"
      "out %[count], %[off]\n\tsts %[power], __zero_reg__\n\tin %[found], %[count]"
      : [found] "=r"(found)
      : [count] "I"(_SFR_IO_ADDR(TCNT0)), [start] "r"((uint8_t)0x10), [power] "n"(_SFR_MEM_ADDR(PRR)),
        [off] "r"((uint8_t)_BV(PRTIM0)));
  report(found);
  OCR0A = 5;
  PRR = _BV(PRTIM0);
  report(OCR0A);
  PRR = 0;
  report(OCR0A);
  end_program();
}
