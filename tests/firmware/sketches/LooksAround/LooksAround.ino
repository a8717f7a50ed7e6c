// Drives around a room. A distance sensor on a servo points ahead. Near an obstacle, it points to both sides.
const int LEFT_EN = 5, LEFT_IN1 = 7, LEFT_IN2 = 8;
const int RIGHT_EN = 6, RIGHT_IN1 = 9, RIGHT_IN2 = 10;
const int PAN = 11, TRIG = 12, ECHO = 13;
const int SPEED = 130;

// Returns the distance in cm, or 400 if no obstacle is nearer.
int distance() {
  digitalWrite(TRIG, LOW);
  delayMicroseconds(2);
  digitalWrite(TRIG, HIGH);
  delayMicroseconds(10);
  digitalWrite(TRIG, LOW);
  unsigned long us = pulseIn(ECHO, HIGH, 40000UL);
  return us == 0 || us > 23000UL ? 400 : (int)(us / 58);
}

// Turns the servo as the Servo library would: a pulse every 20 ms.
void look(int angle) {
  unsigned int us = 544 + (unsigned int)(angle * 10.31);
  for (int i = 0; i < 25; i++) {
    digitalWrite(PAN, HIGH);
    delayMicroseconds(us);
    digitalWrite(PAN, LOW);
    delay(18);
  }
}

void drive(int left, int right) {
  digitalWrite(LEFT_IN1, left >= 0);
  digitalWrite(LEFT_IN2, left < 0);
  analogWrite(LEFT_EN, abs(left));
  digitalWrite(RIGHT_IN1, right >= 0);
  digitalWrite(RIGHT_IN2, right < 0);
  analogWrite(RIGHT_EN, abs(right));
}

void setup() {
  Serial.begin(9600);
  for (int pin = 5; pin <= 12; pin++) pinMode(pin, OUTPUT);
  pinMode(ECHO, INPUT);
  look(90);
  Serial.print("ahead ");
  Serial.println(distance());
}

void loop() {
  int ahead = distance();
  if (ahead > 25) {
    drive(SPEED, SPEED);
    delay(30);
    return;
  }
  drive(0, 0);
  look(160);
  int left = distance();
  look(20);
  int right = distance();
  look(90);
  Serial.print("left ");
  Serial.print(left);
  Serial.print(" right ");
  Serial.println(right);
  int turn = left > right ? -SPEED : SPEED;
  drive(turn, -turn);
  delay(350);
  drive(0, 0);
}
