// In phase and frequency correct PWM a write to OCR1A takes effect at BOTTOM.
// Source: DS40002061B, 16.9.5, table 16-4
// Expect: 04 03 00 08 07
// Chips: atmega328p atmega2560 atmega32u4
// Host: assembler
#include "cycles.h"

// TCNT1 is 0 when the timer starts; OCR1A becomes 8 two cycles later.
#define COUNT(nops)                                                                              \
  ({                                                                                             \
    uint8_t found_;                                                                              \
    TCCR1B = 0;                                                                                  \
    TCCR1A = 0;                                                                                  \
    OCR1A = 4;                                                                                   \
    TCNT1 = 0;                                                                                   \
    TCCR1A = _BV(WGM10);                                                                         \
    __asm__ volatile("sts %1, %2\n\tsts %3, %4\n\t.rept %5\n\tnop\n\t.endr\n\tlds %0, %6"        \
                     : "=r"(found_)                                                              \
                     : "n"(_SFR_MEM_ADDR(TCCR1B)), "r"((uint8_t)(_BV(WGM13) | _BV(CS10))),       \
                       "n"(_SFR_MEM_ADDR(OCR1AL)), "r"((uint8_t)8), "n"(nops), "n"(_SFR_MEM_ADDR(TCNT1L))); \
    found_;                                                                                      \
  })

int main(void) {
  report(COUNT(1));
  report(COUNT(2));
  report(COUNT(5));
  report(COUNT(13));
  report(COUNT(14));
  end_program();
}
