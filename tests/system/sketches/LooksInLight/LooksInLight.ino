// A line follower. A letter on the serial line selects how it reads its five sensors:
//   t  thresholds at half scale, one conversion each      r  raw, unscaled
//   c  scaled by a calibration turn over the line         m  as c, with means over 10 ms
//   d  difference with and without its own light          w  as d, waits 1 ms whenever it switches the light
//   e  as t, ends at the first reading without a line     l  as t, ends after 250 ms without a line
//   b  as t, ends if one battery reading is 20 steps low  v  as b, with the mean of 16 readings
//   k  keeps the middle sensor on the line's right edge
//   p  prints the middle sensor and the battery forever
const byte EMITTERS = 12, BATTERY = A5;
const byte PIN[5] = {A0, A1, A2, A3, A4};
int lo[5] = {1023, 1023, 1023, 1023, 1023}, hi[5];
int raw[5];
int full;
char way;

void look() {
  if (way == 'm') {
    long sum[5] = {0, 0, 0, 0, 0};
    for (byte n = 0; n < 18; n++)
      for (byte i = 0; i < 5; i++) sum[i] += analogRead(PIN[i]);
    for (byte i = 0; i < 5; i++) raw[i] = sum[i] / 18;
    return;
  }
  for (byte i = 0; i < 5; i++) raw[i] = analogRead(PIN[i]);
  if (way != 'd' && way != 'w') return;
  digitalWrite(EMITTERS, LOW);
  if (way == 'w') delay(1);
  for (byte i = 0; i < 5; i++) raw[i] = 1023 - (analogRead(PIN[i]) - raw[i]);
  digitalWrite(EMITTERS, HIGH);
  if (way == 'w') delay(1);
}

bool is_scaled() { return way == 'c' || way == 'm'; }

// Returns a value from 0 (white) to 1000 (black), or the raw reading for `r`.
int share(byte i) {
  if (way == 'r') return raw[i];
  if (!is_scaled()) return raw[i] > 511 ? 1000 : 0;
  long v = (raw[i] - lo[i]) * 1000L / max(hi[i] - lo[i], 1);
  return v < 300 ? 0 : v > 1000 ? 1000 : v;
}

int battery(byte looks) {
  long sum = 0;
  for (byte n = 0; n < looks; n++) sum += analogRead(BATTERY);
  return sum / looks;
}

void drive(int left, int right) {
  digitalWrite(7, left >= 0);
  digitalWrite(8, left < 0);
  digitalWrite(9, right >= 0);
  digitalWrite(10, right < 0);
  analogWrite(5, constrain(abs(left), 0, 255));
  analogWrite(6, constrain(abs(right), 0, 255));
}

void setup() {
  for (byte pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  pinMode(EMITTERS, OUTPUT);
  digitalWrite(EMITTERS, HIGH);
  Serial.begin(115200);
  while (!Serial.available()) {}
  way = Serial.read();
  while (way == 'p') {
    Serial.print(analogRead(A2));
    Serial.print(' ');
    Serial.println(analogRead(BATTERY));
    delay(1);
  }
  full = battery(16);
  if (!is_scaled()) return;
  const unsigned long begin = millis();
  while (millis() - begin < 1600) {
    const bool back = (millis() - begin) / 400 % 4 == 1 || (millis() - begin) / 400 % 4 == 2;
    drive(back ? 45 : -45, back ? -45 : 45);
    look();
    for (byte i = 0; i < 5; i++) {
      lo[i] = min(lo[i], raw[i]);
      hi[i] = max(hi[i], raw[i]);
    }
  }
}

void loop() {
  static int error = 0, before = 0;
  look();
  long sum = 0, weighted = 0;
  for (byte i = 0; i < 5; i++) {
    const int v = share(i);
    sum += v;
    weighted += v * (i - 2L) * 100;
  }
  static unsigned long seen = 0;
  if (sum > 0) seen = millis();
  const bool ends = (way == 'e' && sum == 0) || (way == 'l' && millis() - seen > 250);
  const bool low = (way == 'b' && battery(1) < full - 20) || (way == 'v' && battery(16) < full - 20);
  if (ends || low) {
    drive(0, 0);
    Serial.println(ends ? F("the line ends") : F("the battery is low"));
    for (;;) delay(100);
  }
  if (sum > 0) error = weighted / sum;
  else error = error > 0 ? 300 : -300;
  const int turn = error / 3 + (error - before);
  before = error;
  if (way == 'k') return drive(70 + (raw[2] - 511) / 10, 70 - (raw[2] - 511) / 10);
  drive(70 + turn, 70 - turn);
}
