// Follows a line to and fro. Prints "boot" when it starts. A letter on the serial line selects how it drives:
//   t  turns for a time that was measured at 7.4 V        s  turns until it sees the line again
//   h  starts with full power immediately                 r  raises its power to full within half a second
const byte PIN[3] = {A1, A2, A3};
const int DARK = 500, TURN_MS = 400;
int level[3];
char way;

void drive(int left, int right) {
  digitalWrite(7, left >= 0);
  digitalWrite(8, left < 0);
  digitalWrite(9, right >= 0);
  digitalWrite(10, right < 0);
  analogWrite(5, constrain(abs(left), 0, 255));
  analogWrite(6, constrain(abs(right), 0, 255));
}

bool sees_line() {
  for (byte i = 0; i < 3; i++) level[i] = analogRead(PIN[i]);
  return level[0] > DARK || level[1] > DARK || level[2] > DARK;
}

void stop() {
  digitalWrite(7, HIGH);
  digitalWrite(8, HIGH);
  digitalWrite(9, HIGH);
  digitalWrite(10, HIGH);
  analogWrite(5, 255);
  analogWrite(6, 255);
  delay(150);
}

void setup() {
  for (byte pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  Serial.begin(115200);
  Serial.println(F("boot"));
  while (!Serial.available()) {}
  way = Serial.read();
}

void loop() {
  if (way == 'h' || way == 'r') {
    for (int power = way == 'h' ? 255 : 20; power <= 255; power += 5) {
      drive(power, power);
      delay(10);
    }
    delay(300);
    stop();
    for (;;) delay(100);
  }
  if (sees_line()) {
    const int turn = (level[2] - level[0]) / 20;
    drive(70 + turn, 70 - turn);
    return;
  }
  stop();
  drive(90, -90);
  if (way == 't') {
    delay(TURN_MS);
  } else {
    delay(150);
    while (!sees_line()) {}
  }
  stop();
  drive(60, 60);
  while (analogRead(PIN[1]) < DARK) {}
}
