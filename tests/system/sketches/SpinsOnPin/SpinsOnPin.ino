// Waits for a pin that never becomes low, with the motors off.
void setup() { pinMode(2, INPUT_PULLUP); }

void loop() {
  while (digitalRead(2));
}
