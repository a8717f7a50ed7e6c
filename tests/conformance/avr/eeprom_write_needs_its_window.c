// EEPE starts a write only within 4 cycles after EEMPE was set; EEMPE reads 0 after these cycles.
// Source: DS40002061B, 8.6.3
// Expect: 00 00 02 04 00
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: assembler
#include "report.h"

#define WRITE_BEHIND(nops)                                                                                      \
  ({                                                                                                            \
    uint8_t control;                                                                                            \
    __asm__ volatile("sbi %1, 2\n\t.rept " #nops "\n\tnop\n\t.endr\n\tsbi %1, 1\n\tnop\n\tnop\n\tnop\n\tnop\n\t" \
                     "in %0, %1"                                                                                \
                     : "=r"(control)                                                                            \
                     : "I"(_SFR_IO_ADDR(EECR)));                                                                \
    control;                                                                                                    \
  })
#define MASTER_BEHIND(nops)                                                             \
  ({                                                                                    \
    uint8_t control;                                                                    \
    __asm__ volatile("sbi %1, 2\n\t.rept " #nops "\n\tnop\n\t.endr\n\tin %0, %1"        \
                     : "=r"(control)                                                    \
                     : "I"(_SFR_IO_ADDR(EECR)));                                        \
    control;                                                                            \
  })

int main(void) {
  EECR |= _BV(EEPE);
  report(EECR);
  report(WRITE_BEHIND(3));
  report(WRITE_BEHIND(2));
  while (EECR & _BV(EEPE)) {
  }
  report(MASTER_BEHIND(3));
  NOPS(4);
  report(MASTER_BEHIND(4));
  end_program();
}
