// Follows a line for 1.2 m at 60 mm/s. A letter on the serial line selects the speed controller:
//   p  proportional     i  proportional and integral
const byte PIN[5] = {A0, A1, A2, A3, A4};
const int TARGET = 60, FAR = 1200;   // mm/s and mm
const float MM = 0.651;               // per count
volatile long left_counts, right_counts;
char way;

void count_left() { left_counts++; }
void count_right() { right_counts++; }

long counts() {
  noInterrupts();
  long sum = left_counts + right_counts;
  interrupts();
  return sum;
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
  attachInterrupt(digitalPinToInterrupt(2), count_left, RISING);
  attachInterrupt(digitalPinToInterrupt(3), count_right, RISING);
  Serial.begin(115200);
  while (!Serial.available()) {}
  way = Serial.read();
}

void loop() {
  static unsigned long looked = 0;
  static long before = 0;
  static float power = 34, missing = 0;
  if (millis() - looked >= 20) {
    looked = millis();
    const long now = counts();
    const float speed = (now - before) / 2.0 * MM / 0.02;
    before = now;
    const float error = TARGET - speed;
    if (way == 'i') missing = constrain(missing + error * 0.02, -100, 300);
    power = 34 + 0.05 * error + 0.5 * missing;
    if (now / 2 * MM > FAR) {
      drive(0, 0);
      for (;;) delay(100);
    }
  }
  long sum = 0, weighted = 0;
  for (byte i = 0; i < 5; i++) {
    const int v = analogRead(PIN[i]);
    sum += v;
    weighted += v * (i - 2L) * 20;
  }
  const int turn = sum > 1200 ? weighted / sum : 0;   // no sensor is dark in a gap
  drive(power + turn, power - turn);
}
