// The LED is dim on a real robot, because its pin is not an output.

const int LED = 13;

void setup() {
  digitalWrite(LED, HIGH);
}

void loop() {}
