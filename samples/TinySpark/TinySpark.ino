// Digispark (ATtiny85): two motors on transistors, two sensors, nothing else. 5 lines of logic.
void setup() {
  pinMode(0, OUTPUT);
  pinMode(1, OUTPUT);
}
void loop() {
  analogWrite(0, digitalRead(2) ? 0 : 200);
  analogWrite(1, digitalRead(4) ? 0 : 200);
}
