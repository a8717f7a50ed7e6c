// Turns a car's servo on pin 9 by 250 us from its middle, with pulses that every board can generate. Then
// switches the motor on.
const int MOTOR = 5, FORWARD = 7, BACKWARD = 8, SERVO = 9;

void pulse() {
  digitalWrite(SERVO, HIGH);
  delayMicroseconds(1472 + 250);
  digitalWrite(SERVO, LOW);
  delay(18);
}

void setup() {
  pinMode(MOTOR, OUTPUT);
  pinMode(FORWARD, OUTPUT);
  pinMode(BACKWARD, OUTPUT);
  pinMode(SERVO, OUTPUT);
  for (int i = 0; i < 20; i++) pulse();
  digitalWrite(FORWARD, HIGH);
  analogWrite(MOTOR, 110);
}

void loop() { pulse(); }
