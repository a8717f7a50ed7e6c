/*
 * UKMARS line follower: a white line of 10 mm on black. The markers on the right are the start and, a little
 * later, the finish. Markers on the left show corners. On this course, arcs and straights alternate. Each
 * corner marker therefore switches between the slow and the fast speed.
 */
#define LEFT_MARK 4
#define RIGHT_MARK 12

const uint8_t kLine[5] = {A0, A1, A2, A3, A4};
const int kArcSpeed = 75, kStraightSpeed = 95;  // out of 255

class Motor {
 public:
  Motor(uint8_t en, uint8_t in1, uint8_t in2) : en_(en), in1_(in1), in2_(in2) {}
  void begin() {
    pinMode(en_, OUTPUT);
    pinMode(in1_, OUTPUT);
    pinMode(in2_, OUTPUT);
  }
  void set(int speed) {
    digitalWrite(in1_, speed > 0);
    digitalWrite(in2_, speed < 0);
    analogWrite(en_, min(abs(speed), 255));
  }

 private:
  uint8_t en_, in1_, in2_;
};

Motor left(5, 7, 8), right(6, 9, 10);

struct Marker {
  uint8_t pin;
  bool on;
  bool passed() {  // returns true once, just after the marker
    bool now = digitalRead(pin) == LOW;
    bool left_it = on && !now;
    on = now;
    return left_it;
  }
};

Marker corner = {LEFT_MARK, false}, gate = {RIGHT_MARK, false};
int last = 0;
uint8_t gates = 0, corners = 0;
unsigned long start_ms, stop_at = 0;

int error() {
  long sum = 0, moment = 0;
  for (int8_t i = 0; i < 5; i++) {
    int white = 1023 - analogRead(kLine[i]);
    if (white < 250) continue;
    sum += white;
    moment += (long)white * (i - 2) * 100;
  }
  if (!sum) return last < 0 ? -250 : 250;
  return moment / sum;
}

void setup() {
  Serial.begin(115200);
  left.begin();
  right.begin();
  delay(1000);
}

void loop() {
  if (corner.passed()) corners++;
  if (gate.passed()) {
    gates++;
    if (gates == 1) start_ms = millis();
    if (gates == 2) {
      stop_at = millis() + 150;
      Serial.print(F("lap "));
      Serial.print((millis() - start_ms) / 1000.0);
      Serial.print(F(" s, corners "));
      Serial.println(corners);
    }
  }
  if (stop_at && millis() > stop_at) {
    left.set(0);
    right.set(0);
    return;
  }
  int now = error();
  int turn = now * 3 / 10 + (now - last) * 2;
  last = now;
  int speed = corners % 2 ? kArcSpeed : kStraightSpeed;
  left.set(speed + turn);
  right.set(speed - turn);
  delay(3);
}
