// In phase and frequency correct PWM, TCNT1 = 0 makes a new OCR1A take effect immediately.
// Source: DS40002061B, 16.9.5
// Expect: 01 03 05 03
// Chips: atmega328p atmega2560 atmega32u4
// Host: assembler
#include "cycles.h"

int main(void) {
  uint8_t a, b, c, d;
  OCR1A = 8;
  TCCR1A = _BV(WGM10);
  TCCR1B = _BV(WGM13) | _BV(CS10);
  TCNT1 = 0;
  __asm__ volatile(
      "sts %[compare], %[five]\n\tsts %[count], __zero_reg__\n\t"
      "lds %[a], %[count]\n\tlds %[b], %[count]\n\tlds %[c], %[count]\n\tlds %[d], %[count]"
      : [a] "=&r"(a), [b] "=&r"(b), [c] "=&r"(c), [d] "=&r"(d)
      : [compare] "n"(_SFR_MEM_ADDR(OCR1AL)), [count] "n"(_SFR_MEM_ADDR(TCNT1L)), [five] "r"((uint8_t)5));
  report(a);
  report(b);
  report(c);
  report(d);
  end_program();
}
