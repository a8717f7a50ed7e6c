// WDP can be changed and WDE cleared only within 4 cycles after writing WDCE with WDE; WDCE reads 0 after
// these cycles.
// Source: DS40002061B, 11.8, 11.9.2
// Expect: 08 08 08 0e 18 08 00
// Chips: atmega328p atmega2560 atmega32u4
// Host: assembler
#include "report.h"

// STS takes 2 cycles.
#define WRITE_BEHIND(nops, value)                                                                \
  __asm__ volatile("sts %0, %1\n\t.rept " #nops "\n\tnop\n\t.endr\n\tsts %0, %2" ::"n"(&WDTCSR), \
                   "r"((uint8_t)(_BV(WDCE) | _BV(WDE))), "r"((uint8_t)(value)))
#define WDTCSR_BEHIND(nops)                                                                    \
  ({                                                                                           \
    uint8_t control;                                                                           \
    __asm__ volatile("sts %1, %2\n\t.rept " #nops "\n\tnop\n\t.endr\n\tlds %0, %1"             \
                     : "=r"(control)                                                           \
                     : "n"(&WDTCSR), "r"((uint8_t)(_BV(WDCE) | _BV(WDE))));                    \
    control;                                                                                   \
  })

int main(void) {
  WDTCSR = _BV(WDE);
  WDTCSR = _BV(WDE) | _BV(WDP2);
  report(WDTCSR);
  WDTCSR = 0;
  report(WDTCSR);
  WRITE_BEHIND(3, _BV(WDE) | _BV(WDP2) | _BV(WDP1));
  report(WDTCSR);
  WRITE_BEHIND(2, _BV(WDE) | _BV(WDP2) | _BV(WDP1));
  report(WDTCSR);
  WRITE_BEHIND(0, _BV(WDE));
  report(WDTCSR_BEHIND(2));
  NOPS(4);
  report(WDTCSR_BEHIND(3));
  NOPS(4);
  WRITE_BEHIND(0, 0);
  report(WDTCSR);
  end_program();
}
