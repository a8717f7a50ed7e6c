// Drag race: waits for the button, drives three metres along a line at high speed, and stops.
// Encoders measure the distance: 51.45 * 3 periods per turn of a 32 mm wheel.

const int SENSORS[] = {A0, A1, A2, A3, A4};
const int ENA = 5, IN1 = 7, IN2 = 8, ENB = 6, IN3 = 9, IN4 = 10;
const int START = 4;

const float MM_PER_COUNT = 32.0 * PI / (51.45 * 3);
const float FINISH_MM = 3100 + 150;   // from the start position to a point after the finish line
const int TOP = 230;

volatile long countLeft = 0, countRight = 0;
void onLeft() { countLeft++; }
void onRight() { countRight++; }

enum { WAITING, RACING, BRAKING, DONE } state = WAITING;
int speed = 0;
float lastError = 0;
unsigned long since = 0;

void motors(int l, int r) {
  digitalWrite(IN1, l >= 0 ? HIGH : LOW);
  digitalWrite(IN2, l >= 0 ? LOW : HIGH);
  digitalWrite(IN3, r >= 0 ? HIGH : LOW);
  digitalWrite(IN4, r >= 0 ? LOW : HIGH);
  analogWrite(ENA, constrain(abs(l), 0, 255));
  analogWrite(ENB, constrain(abs(r), 0, 255));
}

float lineError() {
  float sum = 0, where = 0;
  for (int i = 0; i < 5; i++) {
    float white = max(0, 900 - analogRead(SENSORS[i]));
    sum += white;
    where += white * (i - 2);
  }
  return sum < 200 ? lastError : where / sum;
}

long travelled() {
  noInterrupts();
  long counts = countLeft + countRight;
  interrupts();
  return counts / 2 * MM_PER_COUNT;
}

void setup() {
  Serial.begin(115200);
  int outputs[] = {ENA, IN1, IN2, ENB, IN3, IN4};
  for (int pin : outputs) pinMode(pin, OUTPUT);
  pinMode(START, INPUT_PULLUP);
  attachInterrupt(digitalPinToInterrupt(2), onLeft, RISING);
  attachInterrupt(digitalPinToInterrupt(3), onRight, RISING);
  Serial.println("ready");
}

void loop() {
  switch (state) {
    case WAITING:
      if (digitalRead(START) == LOW) state = RACING;
      return;
    case RACING:
      if (speed < TOP) speed += 2;
      if (travelled() > FINISH_MM) {
        state = BRAKING;
        since = millis();
      }
      break;
    case BRAKING:
      speed = max(0, speed - 2);
      if (speed == 0) {
        motors(0, 0);
        Serial.print("stopped after ");
        Serial.print(travelled());
        Serial.println(" mm");
        state = DONE;
      }
      break;
    case DONE:
      return;
  }
  float error = lineError();
  float turn = 14 * error + 90 * (error - lastError);
  lastError = error;
  motors(speed + turn, speed - turn);
  delay(2);
}
