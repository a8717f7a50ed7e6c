// Digispark (ATtiny85) with two motors on transistors, and two sensors.
void setup() {
  pinMode(0, OUTPUT);
  pinMode(1, OUTPUT);
}
void loop() {
  analogWrite(0, digitalRead(2) ? 0 : 200);
  analogWrite(1, digitalRead(4) ? 0 : 200);
}
