// Follows a line with two continuous-rotation servos and one digital sensor on each side of the line.
const int LEFT_WHEEL = 9, RIGHT_WHEEL = 10;
const int LEFT_SENSOR = A0, RIGHT_SENSOR = A2;

// Sends one pulse to each servo in 20 ms. A longer pulse turns a servo counter-clockwise, seen from outside.
void pulse(int left, int right) {
  digitalWrite(LEFT_WHEEL, HIGH);
  delayMicroseconds(1500 + left);
  digitalWrite(LEFT_WHEEL, LOW);
  digitalWrite(RIGHT_WHEEL, HIGH);
  delayMicroseconds(1500 - right);
  digitalWrite(RIGHT_WHEEL, LOW);
  delay(15);
}

void setup() {
  pinMode(LEFT_WHEEL, OUTPUT);
  pinMode(RIGHT_WHEEL, OUTPUT);
}

void loop() {
  bool left = digitalRead(LEFT_SENSOR);
  bool right = digitalRead(RIGHT_SENSOR);
  if (left == right) {
    pulse(450, 450);
  } else if (left) {
    pulse(100, 400);
  } else {
    pulse(400, 100);
  }
}
