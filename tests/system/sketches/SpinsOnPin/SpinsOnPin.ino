// Waits for a pin that nobody ever pulls low, with the motors off.
void setup() { pinMode(2, INPUT_PULLUP); }

void loop() {
  while (digitalRead(2));
}
