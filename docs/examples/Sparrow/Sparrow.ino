// Sparrow: three digital line sensors, two gear motors on an L298N.
const int LEFT_SENSOR = A0, MIDDLE_SENSOR = A1, RIGHT_SENSOR = A2;  // HIGH over the line
const int ENA = 3, IN1 = 4, IN2 = 2;                                // left motor
const int ENB = 11, IN3 = 12, IN4 = 8;                              // right motor
const int SPEED = 90, TURN = 100;                                   // duty cycles, of 255

void motor(int enable, int forward, int backward, int speed) {
  digitalWrite(forward, speed > 0);
  digitalWrite(backward, speed < 0);
  analogWrite(enable, abs(speed));
}

void drive(int left, int right) {
  motor(ENA, IN1, IN2, left);
  motor(ENB, IN3, IN4, right);
}

void setup() {
  pinMode(ENA, OUTPUT);
  pinMode(IN1, OUTPUT);
  pinMode(IN2, OUTPUT);
  pinMode(ENB, OUTPUT);
  pinMode(IN3, OUTPUT);
  pinMode(IN4, OUTPUT);
}

void loop() {
  if (digitalRead(LEFT_SENSOR)) drive(-TURN, TURN);
  else if (digitalRead(RIGHT_SENSOR)) drive(TURN, -TURN);
  else if (digitalRead(MIDDLE_SENSOR)) drive(SPEED, SPEED);
}
