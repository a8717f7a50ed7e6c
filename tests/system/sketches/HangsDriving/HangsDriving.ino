// Switches the motors on, and reads nothing after that.
void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  analogWrite(5, 90);
  analogWrite(6, 90);
}

void loop() {
  for (;;);
}
