/*
  Solves a line maze in two runs. The first run follows the left-hand rule, and cuts dead ends off its path.
  The second run starts when the button is pressed, and drives the shortened path.

  Reads a QTR-8RC without a library: charges each sensor, then measures the time until its pin is LOW.
*/
#define NUM 6
const unsigned char QTR[NUM] = {A0, A1, A2, A3, A4, A5};
#define EMITTER   12
#define BUTTON    2
#define LED       13
#define M1_PWM    3
#define M1_IN1    4
#define M1_IN2    5
#define M2_PWM    11
#define M2_IN1    8
#define M2_IN2    7

unsigned int sensor[NUM];
char path[100] = "";
unsigned char path_length = 0;

void read_sensors() {
  digitalWrite(EMITTER, HIGH);
  delayMicroseconds(200);
  for (int i = 0; i < NUM; i++) {
    sensor[i] = 2000;
    pinMode(QTR[i], OUTPUT);
    digitalWrite(QTR[i], HIGH);
  }
  delayMicroseconds(10);
  for (int i = 0; i < NUM; i++) {
    pinMode(QTR[i], INPUT);
    digitalWrite(QTR[i], LOW);
  }
  unsigned long start = micros();
  while (micros() - start < 2000) {
    unsigned int t = micros() - start;
    for (int i = 0; i < NUM; i++)
      if (digitalRead(QTR[i]) == LOW && t < sensor[i]) sensor[i] = t;
  }
  digitalWrite(EMITTER, LOW);
}

bool black(int i) { return sensor[i] > 900; }

void set_motors(int left, int right) {
  digitalWrite(M1_IN1, left > 0);
  digitalWrite(M1_IN2, left < 0);
  digitalWrite(M2_IN1, right > 0);
  digitalWrite(M2_IN2, right < 0);
  analogWrite(M1_PWM, abs(left));
  analogWrite(M2_PWM, abs(right));
}

void follow_segment() {
  int last = 0;
  while (1) {
    read_sensors();
    long weighted = 0;
    unsigned int total = 0;
    for (int i = 0; i < NUM; i++) {
      unsigned int v = sensor[i] > 300 ? sensor[i] - 300 : 0;
      weighted += (long)v * i * 1000;
      total += v;
    }
    if (!black(1) && !black(2) && !black(3) && !black(4)) return;   // a dead end
    if (black(0) || black(NUM - 1)) return;                         // an intersection
    int position = total ? weighted / total : 2500;
    int p = position - 2500;
    int diff = p / 22 + (p - last) / 4;
    last = p;
    diff = constrain(diff, -60, 60);
    set_motors(diff < 0 ? 70 + diff : 70, diff < 0 ? 70 : 70 - diff);
  }
}

void turn(char dir) {
  if (dir == 'S') return;
  int sign = dir == 'L' ? -1 : 1;
  set_motors(sign * 60, -sign * 60);
  if (dir != 'B') {          // first turns off the line under the robot
    do read_sensors(); while (black(2) || black(3));
  } else {
    delay(150);
  }
  do read_sensors(); while (!black(dir == 'L' ? 2 : 3));
  set_motors(0, 0);
  delay(50);
}

char select_turn(bool left, bool straight, bool right) {
  if (left) return 'L';
  if (straight) return 'S';
  if (right) return 'R';
  return 'B';
}

// Replaces the last three turns by one turn if the middle one is B (back from a dead end).
void simplify_path() {
  if (path_length < 3 || path[path_length - 2] != 'B') return;
  int total = 0;
  for (int i = 1; i <= 3; i++) {
    switch (path[path_length - i]) {
      case 'R': total += 90; break;
      case 'L': total += 270; break;
      case 'B': total += 180; break;
    }
  }
  total %= 360;
  path[path_length - 3] = total == 0 ? 'S' : total == 90 ? 'R' : total == 180 ? 'B' : 'L';
  path_length -= 2;
}

// Drives on a little to find the ways out of the intersection. Returns true at the goal, a large black area.
bool look_around(bool &left, bool &straight, bool &right) {
  left = right = false;
  set_motors(60, 60);
  for (int i = 0; i < 20; i++) {
    read_sensors();
    if (black(0)) left = true;
    if (black(NUM - 1)) right = true;
    delay(4);
  }
  int dark = 0;
  for (int i = 0; i < NUM; i++) dark += black(i);
  bool goal = dark >= NUM - 1;
  for (int i = 0; i < 16 && !goal; i++) {     // moves the wheels onto the intersection
    read_sensors();
    delay(6);
  }
  read_sensors();
  straight = black(1) || black(2) || black(3) || black(4);
  return goal;
}

void wait_button() {
  while (digitalRead(BUTTON)) ;
  delay(500);
}

void setup() {
  pinMode(EMITTER, OUTPUT);
  pinMode(BUTTON, INPUT_PULLUP);
  pinMode(LED, OUTPUT);
  pinMode(M1_PWM, OUTPUT); pinMode(M1_IN1, OUTPUT); pinMode(M1_IN2, OUTPUT);
  pinMode(M2_PWM, OUTPUT); pinMode(M2_IN1, OUTPUT); pinMode(M2_IN2, OUTPUT);
  Serial.begin(9600);
  Serial.println(F("maze"));
  wait_button();
}

void loop() {
  bool left, straight, right;

  // first run
  while (1) {
    follow_segment();
    if (look_around(left, straight, right)) break;
    char dir = select_turn(left, straight, right);
    turn(dir);
    path[path_length++] = dir;
    simplify_path();
  }
  set_motors(0, 0);
  path[path_length] = 0;
  Serial.print(F("path "));
  Serial.println(path);

  // second run, at each press of the button
  while (1) {
    digitalWrite(LED, HIGH);
    wait_button();
    digitalWrite(LED, LOW);
    for (int i = 0; i < path_length; i++) {
      follow_segment();
      look_around(left, straight, right);
      turn(path[i]);
    }
    follow_segment();
    set_motors(0, 0);
    Serial.println(F("solved"));
  }
}
