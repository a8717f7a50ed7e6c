// Sleeps between timer 0's interrupts, and occasionally toggles a pin.
#include <avr/sleep.h>

void setup() {
  pinMode(13, OUTPUT);
  set_sleep_mode(SLEEP_MODE_IDLE);
}

void loop() {
  digitalWrite(13, millis() >> 9 & 1);
  sleep_mode();
}
