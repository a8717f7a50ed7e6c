// Drives a lap of Robotrace, a white line on black. The first mark right of the line is the start, the second
// mark is the goal. Marks on the left are corners. At a crossing, both mark sensors see the crossing line.
const byte LINE[5] = {A0, A1, A2, A3, A4};
const byte LEFT_MARK = 4, RIGHT_MARK = 12, LAMP = 13;
const byte LEFT_PWM = 5, LEFT_IN1 = 7, LEFT_IN2 = 8;
const byte RIGHT_PWM = 6, RIGHT_IN1 = 9, RIGHT_IN2 = 10;

const int SPEED = 90;               // out of 255
const int KP = 13, KD = 60;         // per 100 units of position
const int STOP_AFTER = 350;         // ms after the goal mark; still within the goal area
const unsigned long CROSSING = 60;  // maximum ms from one mark sensor to the other at a crossing

int lastPosition = 0;
byte marks = 0;      // on the right
byte corners = 0;    // on the left
bool wasLeft = false, wasRight = false, rightIsMark = false;
unsigned long leftAt = 0, startAt = 0, goalAt = 0;

void drive(int left, int right) {
  digitalWrite(LEFT_IN1, left >= 0);
  digitalWrite(LEFT_IN2, left < 0);
  digitalWrite(RIGHT_IN1, right >= 0);
  digitalWrite(RIGHT_IN2, right < 0);
  analogWrite(LEFT_PWM, constrain(abs(left), 0, 255));
  analogWrite(RIGHT_PWM, constrain(abs(right), 0, 255));
}

// Returns -200 (line under the left sensor) to 200 (right), and -250 or 250 if the line was lost to a side.
int position() {
  long sum = 0, weighted = 0;
  for (byte i = 0; i < 5; i++) {
    int light = 1023 - analogRead(LINE[i]);
    if (light < 300) continue;
    sum += light;
    weighted += (long)light * (i - 2) * 100;
  }
  if (sum == 0) return lastPosition < 0 ? -250 : 250;
  return weighted / sum;
}

void onRightMark(unsigned long now) {
  marks++;
  if (marks == 1) {
    startAt = now;
    digitalWrite(LAMP, HIGH);
    Serial.println(F("start"));
  } else if (marks == 2) {
    goalAt = now;
    digitalWrite(LAMP, LOW);
    Serial.print(F("goal after "));
    Serial.print((now - startAt) / 100);
    Serial.print(F(" tenths, corners "));
    Serial.println(corners);
  }
}

void watchMarks() {
  unsigned long now = millis();
  bool left = digitalRead(LEFT_MARK) == LOW, right = digitalRead(RIGHT_MARK) == LOW;  // LOW = white
  if (left && !wasLeft) {
    leftAt = now;
    if (right) rightIsMark = false;
    else corners++;
  }
  if (right && !wasRight) {
    rightIsMark = !left && now - leftAt > CROSSING;
    if (!rightIsMark) corners--;
  }
  if (!right && wasRight && rightIsMark) onRightMark(now);
  wasLeft = left;
  wasRight = right;
}

void setup() {
  Serial.begin(115200);
  const byte OUTPUTS[] = {LEFT_PWM, LEFT_IN1, LEFT_IN2, RIGHT_PWM, RIGHT_IN1, RIGHT_IN2, LAMP};
  for (byte pin : OUTPUTS) pinMode(pin, OUTPUT);
  delay(500);
}

void loop() {
  watchMarks();
  if (goalAt != 0 && millis() - goalAt > STOP_AFTER) {
    drive(0, 0);
    return;
  }
  int now = position();
  int turn = ((long)KP * now + (long)KD * (now - lastPosition)) / 40;
  lastPosition = now;
  drive(SPEED + turn, SPEED - turn);
  delay(4);
}
