// Keeps the line between the sensors S2 and S4 of uno5, on A1 and A3.
#include "steering.h"

const int kCruise = 110;

void setup() {
  for (int pin = 5; pin <= 10; ++pin) pinMode(pin, OUTPUT);
  Serial.begin(115200);
  Serial.println("ready");
}

void wheel(int enable, int forward, int backward, int speed) {
  digitalWrite(forward, speed >= 0);
  digitalWrite(backward, speed < 0);
  analogWrite(enable, constrain(abs(speed), 0, 255));
}

void loop() {
  int difference = steer(analogRead(A1), analogRead(A3));
  wheel(5, 7, 8, kCruise + difference / 2);
  wheel(6, 9, 10, kCruise - difference / 2);
  delay(2);
}
