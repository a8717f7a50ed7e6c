// Sleeps between two control steps, and parks at the end.
#include <avr/power.h>
#include <avr/sleep.h>
#include <util/delay.h>

void setup() {
  set_sleep_mode(SLEEP_MODE_IDLE);
  power_adc_disable();
  _delay_ms(2);
  _delay_us(1.5);
  delayMicroseconds(10);
}

void loop() {
  sleep_mode();
  if (millis() > 1000) {
    cli();
    sleep_enable();
    sleep_cpu();
  }
}
