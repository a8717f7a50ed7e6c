// The watchdog resets the chip repeatedly.
#include <avr/wdt.h>

void work() {
  for (;;) {
    if (digitalRead(2) == 7) break;
  }
}

void setup() {
  wdt_enable(WDTO_60MS);
  work();
}

void loop() {}
