// The prescaler runs even if no timer uses it: the first count depends on its phase, not on the timer's
// start.
// Source: DS40002061B, 17.1
// Expect: 00 01 00 01 00 01
// Chips: atmega328p atmega2560 atmega32u4
// Host: assembler
#include "cycles.h"

// The prescaler is at 0; the timer starts `wait` + 1 cycles later, and is read `nops` + 1 cycles after that.
#define COUNT(wait, nops)                                                                                   \
  ({                                                                                                        \
    uint8_t found_;                                                                                         \
    TCCR0B = 0;                                                                                             \
    TCNT0 = 0;                                                                                              \
    __asm__ volatile("out %1, %2\n\t.rept %3\n\tnop\n\t.endr\n\tout %4, %5\n\t.rept %6\n\tnop\n\t.endr\n\tin %0, %7" \
                     : "=r"(found_)                                                                         \
                     : "I"(_SFR_IO_ADDR(GTCCR)), "r"((uint8_t)_BV(PSRSYNC)), "n"(wait), "I"(_SFR_IO_ADDR(TCCR0B)), \
                       "r"((uint8_t)_BV(CS01)), "n"(nops), "I"(_SFR_IO_ADDR(TCNT0)));                       \
    found_;                                                                                                 \
  })

int main(void) {
  report(COUNT(3, 3));
  report(COUNT(3, 4));
  report(COUNT(6, 0));
  report(COUNT(6, 1));
  report(COUNT(7, 7));
  report(COUNT(7, 8));
  end_program();
}
