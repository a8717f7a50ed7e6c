/*
  RoboCupJunior Rescue Line Entry: gaps, speed bumps, a ramp, an obstacle, debris and a sharp corner. The
  robot stops at the silver tape before the evacuation zone, because it cannot carry cans.

  Encoders control the speed, with an integral term. In infrared, silver is only slightly brighter than white.
  The sum of all five sensors is therefore compared with recent readings of the outer two over white.
*/
const byte S[5] = {A0, A1, A2, A3, A6};
const byte EN_L = 5, IN1_L = 7, IN2_L = 8, EN_R = 6, IN1_R = 9, IN2_R = 10;
const byte BUMPER = 12;

const float MM = 0.651;            // mm per count
const int SPEED = 150;             // mm/s
const int POWER = 50;              // approximate PWM for SPEED on level floor
const int TRACK = 98;              // mm
const int GAP_MM = 200;
const float SILVER = 0.3;          // silver reads less than this share of white

int white[5], black;               // readings over white (per sensor) and black
int raw[5];
int level[5];                      // 0 white to 100 black
volatile long left_counts, right_counts;
long straight, line_at;            // ahead() and driven() when the line was last seen
float power = POWER, sum = 0;

void count_left() { left_counts++; }
void count_right() { right_counts++; }

long counts(bool difference) {
  noInterrupts();
  long left = left_counts, right = right_counts;
  interrupts();
  return difference ? left - right : left + right;
}

long ahead() { return counts(true); }              // counts of the left wheel minus the right wheel
long driven() { return counts(false) / 2 * MM; }   // mm, forward or backward

void drive(int left, int right) {
  digitalWrite(IN1_L, left >= 0);   // both inputs high: the motor brakes
  digitalWrite(IN2_L, left <= 0);
  digitalWrite(IN1_R, right >= 0);
  digitalWrite(IN2_R, right <= 0);
  analogWrite(EN_L, left == 0 ? 255 : constrain(abs(left), 0, 255));
  analogWrite(EN_R, right == 0 ? 255 : constrain(abs(right), 0, 255));
}

void stop() {
  drive(0, 0);
  delay(150);
}

void look() {
  for (byte i = 0; i < 5; i++) {
    raw[i] = analogRead(S[i]);
    level[i] = constrain(map(raw[i], white[i], black, 0, 100), 0, 100);
  }
}

bool any_dark() {
  look();
  for (byte i = 0; i < 5; i++)
    if (level[i] > 60) return true;
  return false;
}

// Adjusts the power every 20 ms, so that the robot drives at SPEED.
void keep_speed() {
  static unsigned long looked = 0;
  static long before = 0;
  if (millis() - looked < 20) return;
  const float seconds = (millis() - looked) / 1000.0;
  looked = millis();
  const long now = counts(false);
  const float error = SPEED - (now - before) / 2 * MM / seconds;
  before = now;
  if (seconds > 0.1) return;        // a manoeuvre has happened since the last call
  sum = constrain(sum + error * seconds * 1.5, -60, 120);
  power = constrain(POWER + 0.1 * error + sum, 0, 220);
}

// Drives straight ahead (speed > 0) or back for `mm`. With `to_line`, also stops at a line.
void go(int mm, int speed, bool to_line = false) {
  long to = driven() + mm, before = ahead();
  do {
    int more = constrain((ahead() - before) * 2, -20, 20);
    if (speed < 0) more = -more;
    drive(speed - more, speed + more);
    delay(1);
  } while (driven() < to && !(to_line && any_dark()));
}

// Turns on the spot by `degrees` to the right.
void turn(int degrees) {
  long to = driven() + abs(degrees) * (PI / 360) * TRACK;
  int speed = degrees > 0 ? POWER : -POWER;
  drive(speed, -speed);
  while (driven() < to) ;
  stop();
}

// Returns true at the silver tape at the line's end. The tape is 25 mm long, and wider than the sensor array.
bool sees_silver() {
  static float usual = 0;           // mean reading of the outer two sensors over white
  static byte times = 0;
  int sum = 0;
  for (byte i = 0; i < 5; i++) sum += raw[i];
  if (usual == 0) usual = (white[0] + white[4]) / 2;
  times = sum < 5 * usual * SILVER ? times + 1 : 0;
  if (level[0] < 40 && level[4] < 40) usual += ((raw[0] + raw[4]) / 2 - usual) * 0.01;
  return times == 12;
}

void around() {
  Serial.println(F("obstacle"));
  stop();
  go(60, -POWER);
  stop();
  turn(90);
  go(180, POWER);
  stop();
  turn(-90);
  go(440, POWER);
  stop();
  turn(-90);
  go(400, POWER, true);
  go(55, POWER);
  stop();
  turn(45);
  drive(45, -45);
  do look(); while (level[2] < 60);
  stop();
  sum = 0;
  straight = ahead();
  line_at = driven();
}

// Turns at a right-angled corner, where an outer sensor saw the line on one side before the line ended.
void corner(int side) {
  stop();
  go(40, POWER);
  stop();
  turn(side * 50);
  drive(side * 45, -side * 45);
  do look(); while (level[2] < 60);
  stop();
  sum = 0;
  straight = ahead();
  line_at = driven();
}

void setup() {
  Serial.begin(115200);
  const byte outputs[] = {EN_L, IN1_L, IN2_L, EN_R, IN1_R, IN2_R};
  for (byte pin : outputs) pinMode(pin, OUTPUT);
  pinMode(BUMPER, INPUT_PULLUP);
  attachInterrupt(digitalPinToInterrupt(2), count_left, RISING);
  attachInterrupt(digitalPinToInterrupt(3), count_right, RISING);
  delay(1000);
  // The robot stands on the line: the middle sensor is over black, the outer two are over white.
  long readings[5] = {};
  for (byte n = 0; n < 16; n++)
    for (byte i = 0; i < 5; i++) readings[i] += analogRead(S[i]);
  for (byte i = 0; i < 5; i++) white[i] = readings[i == 0 || i == 4 ? i : i < 2 ? 0 : 4] / 16;
  black = readings[2] / 16;
}

void loop() {
  static int last_error = 0, side = 0;
  static long side_at = 0;
  if (digitalRead(BUMPER) == LOW) {
    around();
    return;
  }
  keep_speed();
  look();
  if (sees_silver()) {
    drive(0, 0);
    Serial.println(F("silver"));
    while (true) delay(1000);
  }
  const bool lifted = level[0] > 50 && level[4] > 50;
  if (!lifted && (level[0] > 60 || level[4] > 60)) {
    side = level[0] > 60 ? -1 : 1;
    side_at = driven();
  }
  const int inner = level[1] + level[2] + level[3];
  int error = 0;
  if (!lifted && inner > 60) {
    error = 100L * (level[3] - level[1]) / inner;
    straight = ahead();
    line_at = driven();
  } else if (!lifted && (level[0] > 60 || level[4] > 60)) {
    error = level[0] > 60 ? -200 : 200;
    line_at = driven();
  } else if (!lifted && side && driven() - side_at < 40) {
    corner(side);
    side = 0;
    return;
  } else if (!lifted && driven() - line_at > GAP_MM) {
    drive(0, 0);
    Serial.println(F("lost"));
    while (true) delay(1000);
  } else {
    error = constrain((straight - ahead()) * 4, -40, 40);
  }
  const int correction = error / 2 + (error - last_error) * 2;
  last_error = error;
  drive(power + correction, power - correction);
  delay(3);
}
