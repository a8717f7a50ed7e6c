// Its LED is dim on a real robot: the pin is never made an output.

const int LED = 13;

void setup() {
  digitalWrite(LED, HIGH);
}

void loop() {}
