// Sleeps in power-down until the watchdog's interrupt, then toggles a pin.
#include <avr/sleep.h>
#include <avr/wdt.h>

ISR(WDT_vect) {}

void setup() {
  pinMode(13, OUTPUT);
  set_sleep_mode(SLEEP_MODE_PWR_DOWN);
  cli();
  MCUSR = 0;
  WDTCSR = _BV(WDCE) | _BV(WDE);
  WDTCSR = _BV(WDIE) | _BV(WDP1);
  sei();
}

void loop() {
  PINB = _BV(PB5);
  sleep_mode();
}
