// EEPM = 1 erases to 0xFF, EEPM = 2 only clears bits; each takes 1.8 ms: 28800 cycles at 16 MHz.
// Source: DS40002061B, 8.6.3, table 8-1
// Expect: 22 20 f0 22 20 30 12 10 ff
// Ends: 400000
// Chips: atmega328p atmega2560 atmega32u4 attiny85
#include "report.h"

static uint8_t stored(void) {
  EEDR = 0x11;
  EECR |= _BV(EERE);
  return EEDR;
}

// The processor is halted for 2 of the 28800 cycles; IN takes 1.
#define WRITE(mode, data)               \
  ({                                    \
    EECR = (mode);                      \
    EEDR = (data);                      \
    EECR |= _BV(EEMPE);                 \
    EECR |= _BV(EEPE);                  \
    __builtin_avr_delay_cycles(28796);  \
    uint8_t before = EECR;              \
    uint8_t after = EECR;               \
    report(before);                     \
    report(after);                      \
    report(stored());                     \
  })

int main(void) {
  EEAR = 0x123;
  WRITE(_BV(EEPM1), 0xF0);
  WRITE(_BV(EEPM1), 0x3C);
  WRITE(_BV(EEPM0), 0x00);
  end_program();
}
