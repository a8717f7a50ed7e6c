// SLEEP does nothing if SE is 0.
// Source: DS40002061B, 10.11.1
// Expect: 05
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

int main(void) {
  SMCR = _BV(SM1);
  sleep_cpu();
  report(5);
  end_program();
}
