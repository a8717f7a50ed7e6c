// A conversion takes 13 clocks of the ADC, from the first rising edge after ADSC.
// Source: 2586Q, 17.5, table 17-1
// Expect: c0 90
// Chips: attiny85
#include "report.h"

// ADEN is set at cycle 0, so rising edges are at 1 + 2 k. ADSC is set at cycle 100: the conversion runs from
// 101 to 127.
#define CONTROL_AT(cycle)                                                                                        \
  ({                                                                                                             \
    uint8_t control;                                                                                             \
    ADCSRA = 0;                                                                                                  \
    __asm__ volatile("out %1, %2\n\t.rept 99\n\tnop\n\t.endr\n\tout %1, %2\n\t.rept %3\n\tnop\n\t.endr\n\tin %0, %1" \
                     : "=r"(control)                                                                             \
                     : "I"(_SFR_IO_ADDR(ADCSRA)), "r"((uint8_t)(_BV(ADEN) | _BV(ADIF) | _BV(ADSC))),             \
                       "n"((cycle) - 101));                                                                      \
    control;                                                                                                     \
  })

int main(void) {
  report(CONTROL_AT(126));
  report(CONTROL_AT(127));
  end_program();
}
