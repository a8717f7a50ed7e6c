// LPM reads the signature row within three cycles after SIGRD and SPMEN are set, and flash after that; the
// bits are cleared after four cycles.
// Source: DS40002061B, 27.8.10, 27.9.1, 28.3
// Expect: 1e 95 0f 21 00 0c
// Host: memory
#include <avr/boot.h>

#include "report.h"

static inline __attribute__((always_inline)) uint8_t read_at_once(uint16_t address) {
  uint8_t value;
  __asm__ volatile("out %1, %2\n\tlpm %0, Z" : "=r"(value) : "I"(_SFR_IO_ADDR(SPMCSR)), "r"((uint8_t)0x21), "z"(address));
  return value;
}

int main(void) {
  report(read_at_once(0));
  report(boot_signature_byte_get(2));
  report(boot_signature_byte_get(4));
  uint8_t soon, later, flash;
  __asm__ volatile(
      "out %3, %4\n\tin %0, %3\n\tnop\n\tnop\n\tnop\n\tin %1, %3\n\t"
      "out %3, %4\n\tnop\n\tnop\n\tnop\n\tlpm %2, Z"
      : "=&r"(soon), "=&r"(later), "=&r"(flash)
      : "I"(_SFR_IO_ADDR(SPMCSR)), "r"((uint8_t)0x21), "z"((uint16_t)0));
  report(soon);
  report(later);
  report(flash);  // the first byte of the reset vector's JMP
  end_program();
}
