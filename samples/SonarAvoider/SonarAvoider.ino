// Avoids obstacles by an ultrasonic sensor on a servo. Moves the servo without a library.
#define TRIG A1
#define ECHO A0
#define SERVO 10

int LeftMotorForward = 7, LeftMotorBackward = 6;
int RightMotorForward = 4, RightMotorBackward = 5;
boolean goesForward = false;
int distance = 100;

void servoTo(int angle) {
  int us = map(angle, 0, 180, 544, 2400);
  for (int i = 0; i < 25; i++) {      // half a second of pulses
    digitalWrite(SERVO, HIGH);
    delayMicroseconds(us);
    digitalWrite(SERVO, LOW);
    delay(18);
  }
}

int readPing() {
  digitalWrite(TRIG, LOW);
  delayMicroseconds(2);
  digitalWrite(TRIG, HIGH);
  delayMicroseconds(10);
  digitalWrite(TRIG, LOW);
  long us = pulseIn(ECHO, HIGH, 25000);
  int cm = us / 29 / 2;
  if (cm == 0) cm = 250;
  return cm;
}

int lookRight() {
  servoTo(20);
  int d = readPing();
  servoTo(90);
  return d;
}

int lookLeft() {
  servoTo(160);
  int d = readPing();
  servoTo(90);
  return d;
}

void moveStop() {
  digitalWrite(RightMotorForward, LOW);
  digitalWrite(LeftMotorForward, LOW);
  digitalWrite(RightMotorBackward, LOW);
  digitalWrite(LeftMotorBackward, LOW);
}

void moveForward() {
  if (!goesForward) {
    goesForward = true;
    digitalWrite(LeftMotorForward, HIGH);
    digitalWrite(RightMotorForward, HIGH);
    digitalWrite(LeftMotorBackward, LOW);
    digitalWrite(RightMotorBackward, LOW);
  }
}

void moveBackward() {
  goesForward = false;
  digitalWrite(LeftMotorBackward, HIGH);
  digitalWrite(RightMotorBackward, HIGH);
  digitalWrite(LeftMotorForward, LOW);
  digitalWrite(RightMotorForward, LOW);
}

void turnRight() {
  digitalWrite(LeftMotorForward, HIGH);
  digitalWrite(RightMotorBackward, HIGH);
  digitalWrite(LeftMotorBackward, LOW);
  digitalWrite(RightMotorForward, LOW);
  delay(330);
  moveStop();
  goesForward = false;
}

void turnLeft() {
  digitalWrite(LeftMotorBackward, HIGH);
  digitalWrite(RightMotorForward, HIGH);
  digitalWrite(LeftMotorForward, LOW);
  digitalWrite(RightMotorBackward, LOW);
  delay(330);
  moveStop();
  goesForward = false;
}

void setup() {
  pinMode(LeftMotorForward, OUTPUT);
  pinMode(RightMotorForward, OUTPUT);
  pinMode(LeftMotorBackward, OUTPUT);
  pinMode(RightMotorBackward, OUTPUT);
  pinMode(TRIG, OUTPUT);
  pinMode(ECHO, INPUT);
  pinMode(SERVO, OUTPUT);
  Serial.begin(9600);
  servoTo(90);
  distance = readPing();
}

void loop() {
  int distanceRight = 0;
  int distanceLeft = 0;
  delay(50);
  if (distance <= 30) {
    moveStop();
    delay(300);
    moveBackward();
    delay(250);
    moveStop();
    delay(300);
    distanceRight = lookRight();
    delay(300);
    distanceLeft = lookLeft();
    delay(300);
    Serial.print("left ");
    Serial.print(distanceLeft);
    Serial.print(" right ");
    Serial.println(distanceRight);
    if (distanceRight >= distanceLeft) turnRight();
    else turnLeft();
  } else {
    moveForward();
  }
  distance = readPing();
}
