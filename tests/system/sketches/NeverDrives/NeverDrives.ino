// Sets motor pins to outputs, but waits for a button before it drives. The button is never pressed.
void setup() {
  pinMode(4, INPUT_PULLUP);
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  while (digitalRead(4) == HIGH) delay(5);
  analogWrite(5, 120);
  analogWrite(6, 120);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
}

void loop() { delay(10); }
