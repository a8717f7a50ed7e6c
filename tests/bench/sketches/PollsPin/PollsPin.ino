// Waits for a button by polling its pin.
void setup() { pinMode(4, INPUT_PULLUP); }

void loop() {
  while (digitalRead(4));
}
