// Follows a line with an ATtiny85: two sensors next to the line, one transistor per motor, no serial port.

const uint8_t LEFT_MOTOR = 0, RIGHT_MOTOR = 1, LEFT_SENSOR = 2, RIGHT_SENSOR = 4, LED = 3;
const uint8_t SPEED = 200, SLOW = 20;

void setup() {
  pinMode(LED, OUTPUT);
}

void loop() {
  const bool left = digitalRead(LEFT_SENSOR), right = digitalRead(RIGHT_SENSOR);
  analogWrite(LEFT_MOTOR, left && !right ? SLOW : SPEED);
  analogWrite(RIGHT_MOTOR, right && !left ? SLOW : SPEED);
  digitalWrite(LED, left || right);
  delay(2);
}
