// Uses wrong pin numbers: on the robot uno2 nothing is connected to 2, 3 and A3.
void setup() {
  pinMode(2, INPUT_PULLUP);
  pinMode(3, OUTPUT);
}

void loop() {
  int speed = analogRead(A3) / 4;
  if (digitalRead(2) == LOW) analogWrite(3, speed);
  delay(10);
}
