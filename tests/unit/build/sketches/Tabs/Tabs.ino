#include "config.h"
#include "src/filter.h"

Filter filter(0.5);

void setup() {
  Serial.begin(BAUD);
  helper();
}

void loop() { Serial.println(filter.next(sum_of(analogRead(A0), second()))); }
