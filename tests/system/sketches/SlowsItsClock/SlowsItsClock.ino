// Sets the clock divisor. The host has no divisor, so a difference on the host does not reveal a bug.
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
