/*
  RoboCupJunior Rescue Line: gaps, intersections with green squares, an obstacle, and the red bar at the end.

  The outer two of five infrared sensors detect green, which is between white and black in infrared. A colour
  sensor in the middle detects red. The encoders measure distances, at 0.65 mm per count.
*/
#include <Wire.h>

const byte S[5] = {A0, A1, A2, A3, A6};
const byte EN_L = 5, IN1_L = 7, IN2_L = 8, EN_R = 6, IN1_R = 9, IN2_R = 10;
const byte BUMPER = 12, TCS = 0x29;

const int SPEED = 55;
const float MM = 1 / 0.651;      // counts per mm
const int TRACK = 98;            // mm
const int GREEN_MM = 7;          // minimum length of a green square
const int KEEP_MM = 50;          // maximum distance from a green square to its intersection
const int GAP_MM = 230;
const int SIDE_MM = 25;          // maximum distance from a corner to the place where no sensor sees the line
const int ROUND_MM = 165;        // radius of the circle around an obstacle, to the axle's centre

int white[5], black;             // readings over white (per sensor) and black
int level[5];                    // 0 white to 100 black
volatile long left_counts, right_counts;
int last_error = 0;
long white_since, white_ahead, green_from[2], green_at[2], side_at[2], ignore_until = 0;
bool in_green[2];

void count_left() { left_counts++; }
void count_right() { right_counts++; }

long ahead() {                   // counts of the left wheel minus the right wheel
  noInterrupts();
  long more = left_counts - right_counts;
  interrupts();
  return more;
}

long driven() {                  // mm, forward or backward
  noInterrupts();
  long sum = left_counts + right_counts;
  interrupts();
  return sum / 2 / MM;
}

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
  for (byte i = 0; i < 5; i++) level[i] = constrain(map(analogRead(S[i]), white[i], black, 0, 100), 0, 100);
}

bool on_line() {
  look();
  return level[1] > 60 || level[2] > 60 || level[3] > 60;
}

bool any_dark() { return on_line() || level[0] > 60 || level[4] > 60; }

// Drives straight ahead (speed > 0) or back for `mm`. With `to_line`, also stops at a line.
void go(int mm, int speed, bool to_line = false) {
  long to = driven() + mm;
  long before = ahead();
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
  int speed = degrees > 0 ? SPEED : -SPEED;
  drive(speed, -speed);
  while (driven() < to) ;
}

// Turns on the spot until the middle sensor is on the line.
void turn_to_line(int speed) {
  drive(speed, -speed);
  do look(); while (level[2] < 60);
  stop();
  last_error = 0;
}

unsigned colour(byte reg) {
  Wire.beginTransmission(TCS);
  Wire.write(0x80 | reg);
  Wire.endTransmission();
  Wire.requestFrom(TCS, (byte)2);
  unsigned low = Wire.read();
  return low | (unsigned)Wire.read() << 8;
}

void set_colour(byte reg, byte value) {
  Wire.beginTransmission(TCS);
  Wire.write(0x80 | reg);
  Wire.write(value);
  Wire.endTransmission();
}

bool sees_red() {
  unsigned red = colour(0x16), green = colour(0x18);
  return red > 3 * green && red > 20;
}

void watch_green(byte side, int value) {
  long now = driven();
  if (value < 18 || value > 60) {
    in_green[side] = false;
  } else if (!in_green[side]) {
    in_green[side] = true;
    green_from[side] = now;
  } else if (now - green_from[side] >= GREEN_MM) {
    green_at[side] = now;
  }
}

// Turns at a sharp corner under the sensors: moves the axle to the corner, then turns left (-1) or right (1).
void corner(int side) {
  go(45, SPEED);
  stop();
  turn(side * 40);
  turn_to_line(side * 45);
  side_at[0] = side_at[1] = -1000;
  ignore_until = driven() + 30;
}

void intersection() {
  long now = driven();
  bool wide_left = level[0] > 75, wide_right = level[4] > 75;
  bool left = now - green_at[0] < KEEP_MM, right = now - green_at[1] < KEEP_MM;
  if (left || right) {
    go(62, SPEED);
    stop();
    Serial.println(left && right ? F("back") : left ? F("left") : F("right"));
    int sign = right ? 1 : -1;
    turn(sign * (left && right ? 140 : 45));
    turn_to_line(sign * 45);
  } else {
    // If the line does not continue, and branches to one side only, this is a corner.
    bool ahead_is_line = false;
    long to = driven() + 28;
    while (driven() < to) {
      drive(SPEED, SPEED);
      look();
      wide_left = wide_left || level[0] > 75;
      wide_right = wide_right || level[4] > 75;
    }
    ahead_is_line = any_dark();
    if (!ahead_is_line && wide_left != wide_right) corner(wide_right ? 1 : -1);
  }
  side_at[0] = side_at[1] = -1000;
  green_at[0] = green_at[1] = -1000;
  ignore_until = driven() + 45;
}

void around() {
  Serial.println(F("obstacle"));
  stop();
  go(40, -SPEED);
  stop();
  turn(90);
  stop();
  // Drives a left circle back to the line. Each wheel's distance is proportional to the radius of its circle.
  noInterrupts();
  long left_0 = left_counts, right_0 = right_counts;
  interrupts();
  long from = driven();
  do {
    noInterrupts();
    long left = left_counts - left_0, right = right_counts - right_0;
    interrupts();
    long more = (left * (ROUND_MM + TRACK / 2) - right * (ROUND_MM - TRACK / 2)) / ROUND_MM;
    int correction = constrain(more * 3, -20L, 20L);
    drive(SPEED * (2L * ROUND_MM - TRACK) / (2 * ROUND_MM) - correction,
          SPEED * (2L * ROUND_MM + TRACK) / (2 * ROUND_MM) + correction);
    delay(1);
  } while (driven() - from < 250 || (!any_dark() && driven() - from < 900));
  go(55, SPEED);
  stop();
  turn(45);
  turn_to_line(45);
  ignore_until = driven() + 30;
}

void setup() {
  Serial.begin(115200);
  Wire.begin();
  set_colour(0x01, 0xFB);        // integration time 12 ms
  set_colour(0x0F, 0x03);        // gain 60
  set_colour(0x00, 0x03);
  const byte outputs[] = {EN_L, IN1_L, IN2_L, EN_R, IN1_R, IN2_R};
  for (byte pin : outputs) pinMode(pin, OUTPUT);
  pinMode(BUMPER, INPUT_PULLUP);
  attachInterrupt(digitalPinToInterrupt(2), count_left, RISING);
  attachInterrupt(digitalPinToInterrupt(3), count_right, RISING);
  delay(1000);
  // The robot stands on the line: the middle sensor is over black, the outer two are over white.
  long sum[5] = {};
  for (byte n = 0; n < 16; n++)
    for (byte i = 0; i < 5; i++) sum[i] += analogRead(S[i]);
  for (byte i = 0; i < 5; i++) white[i] = sum[i == 0 || i == 4 ? i : i < 2 ? 0 : 4] / 16;
  black = sum[2] / 16;
  green_at[0] = green_at[1] = side_at[0] = side_at[1] = -1000;
  white_since = driven();
}

void loop() {
  static unsigned long last_colour = 0;
  static byte reds = 0;
  if (millis() - last_colour > 12) {
    last_colour = millis();
    // Requires red twice: an edge may have passed between the reads of red and green.
    reds = sees_red() ? reds + 1 : 0;
    if (reds == 2) {
      Serial.println(F("red"));
      go(110, SPEED);
      drive(0, 0);
      while (true) delay(1000);
    }
  }
  if (digitalRead(BUMPER) == LOW) {
    around();
    return;
  }
  look();
  bool clear_road = driven() > ignore_until;
  if (clear_road) {
    watch_green(0, level[0]);
    watch_green(1, level[4]);
    // An intersection: on at least one side, the black area is wider than the line.
    if (level[2] > 60 && ((level[0] > 75 && level[1] > 60) || (level[4] > 75 && level[3] > 60))) {
      intersection();
      return;
    }
  }
  if (level[0] > 60) side_at[0] = driven();
  if (level[4] > 60) side_at[1] = driven();
  int error = 0;
  if (on_line() || level[1] + level[2] + level[3] > 60) {
    error = 10L * (level[3] - level[1]) / (level[1] + level[2] + level[3]) * 10;
    white_since = driven();
    white_ahead = ahead();
  } else if (clear_road && (level[0] > 60 || level[4] > 60)) {
    error = level[0] > 60 ? -200 : 200;
    white_since = driven();
  } else if (clear_road && max(side_at[0], side_at[1]) > driven() - SIDE_MM) {
    corner(side_at[1] > side_at[0] ? 1 : -1);
    white_since = driven();
  } else if (driven() - white_since > GAP_MM) {
    stop();
    Serial.println(F("lost"));
    turn_to_line(45);
    white_since = driven();
  } else {
    error = constrain((white_ahead - ahead()) * 4, -40, 40);
  }
  int correction = error / 2 + (error - last_error) * 2;
  last_error = error;
  drive(SPEED + correction, SPEED - correction);
  delay(3);
}
