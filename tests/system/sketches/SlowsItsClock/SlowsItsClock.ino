// The host has no divisor of the clock: what differs says nothing of the sketch.
#include <avr/power.h>

void setup() {
  Serial.begin(9600);
  Serial.println("begins");
  Serial.flush();
  clock_prescale_set(clock_div_4);
  delay(500);
  clock_prescale_set(clock_div_1);
  Serial.println("goes on");
}

void loop() {}
