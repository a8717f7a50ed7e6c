// Erase and write takes 3.4 ms: 54400 cycles at 16 MHz, during which EEPE reads 1.
// Source: DS40002061B, table 8-1
// Expect: 02 00 5a
// Ends: 300000
// Chips: atmega328p atmega2560 atmega32u4 attiny85
// Host: cycles
#include "report.h"

// The processor is halted for 2 of the cycles; IN takes 1.
#define CONTROL_AFTER(cycles)                 \
  ({                                          \
    while (EECR & _BV(EEPE)) {                \
    }                                         \
    EECR |= _BV(EEMPE);                       \
    EECR |= _BV(EEPE);                        \
    __builtin_avr_delay_cycles((cycles) - 3); \
    uint8_t control = EECR;                   \
    control;                                  \
  })

int main(void) {
  EEAR = 7;
  EEDR = 0x5A;
  report(CONTROL_AFTER(54399));
  report(CONTROL_AFTER(54400));
  EEDR = 0;
  EECR |= _BV(EERE);
  report(EEDR);
  end_program();
}
