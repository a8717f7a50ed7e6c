// WDE cannot be cleared while WDRF is set.
// Source: DS40002061B, 11.9.2
// Expect: 08 08 00
// Ends: 1000000
// Chips: atmega328p atmega2560 atmega32u4
// Host: boot loader
#include "report.h"

static inline __attribute__((always_inline)) void switch_off(void) {
  WDTCSR = _BV(WDCE) | _BV(WDE);
  WDTCSR = 0;
}

int main(void) {
  if (!(MCUSR & _BV(WDRF))) {
    WDTCSR = _BV(WDE);
    for (;;) {
    }
  }
  switch_off();
  report(WDTCSR);
  MCUSR = 0;
  report(WDTCSR);
  switch_off();
  report(WDTCSR);
  end_program();
}
