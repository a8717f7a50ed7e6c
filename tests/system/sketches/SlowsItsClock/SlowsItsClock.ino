// Sets the clock divisor. The host has none, so a difference on the host says nothing about the sketch.
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
