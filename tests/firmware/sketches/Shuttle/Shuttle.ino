// Repeatedly drives 200 mm forward and 200 mm back, by counting the edges of a wheel encoder. Robot: uno5.
//
// After each leg, prints the distance, and the time until the wheel started to turn. A longer time is the
// first sign of a weak battery or a worn motor.

const uint8_t LEFT_EN = 5, LEFT_1 = 7, LEFT_2 = 8, RIGHT_EN = 6, RIGHT_1 = 9, RIGHT_2 = 10;
const uint8_t LEFT_ENCODER = 2, RIGHT_ENCODER = 3;

const uint16_t UM_PER_EDGE = 326;                    // pi * 32 mm / (2 * 154.35)
const uint16_t LEG_EDGES = 200UL * 1000 / UM_PER_EDGE;
const uint8_t DUTY = 90;

// Shared with the interrupts.
volatile uint16_t edges = 0;    // of the left wheel
volatile bool turning = false;  // the right wheel

void onLeft() { edges = edges + 1; }
void onRight() { turning = true; }

// An int of two bytes is read in two steps: no interrupt may come between them.
uint16_t edgesSoFar() {
  noInterrupts();
  const uint16_t so_far = edges;
  interrupts();
  return so_far;
}

void drive(int8_t way) {
  const bool forward = way > 0;
  digitalWrite(LEFT_1, forward ? HIGH : LOW);
  digitalWrite(LEFT_2, forward ? LOW : HIGH);
  digitalWrite(RIGHT_1, forward ? HIGH : LOW);
  digitalWrite(RIGHT_2, forward ? LOW : HIGH);
  analogWrite(LEFT_EN, DUTY);
  analogWrite(RIGHT_EN, DUTY);
}

void brake() {
  digitalWrite(LEFT_1, HIGH);
  digitalWrite(LEFT_2, HIGH);
  digitalWrite(RIGHT_1, HIGH);
  digitalWrite(RIGHT_2, HIGH);
}

// Drives forward (1) or back (-1).
void leg(int8_t way) {
  noInterrupts();
  edges = 0;
  turning = false;
  interrupts();
  const uint32_t start = micros();
  drive(way);
  while (!turning) {
  }
  const uint32_t started = micros() - start;
  while (edgesSoFar() < LEG_EDGES) {
  }
  brake();
  delay(300);
  Serial.print(way > 0 ? F("forward ") : F("back "));
  Serial.print(static_cast<uint32_t>(edgesSoFar()) * UM_PER_EDGE / 1000);
  Serial.print(F(" mm, the wheel started after "));
  Serial.print(started);
  Serial.println(F(" us"));
}

void setup() {
  Serial.begin(115200);
  for (uint8_t pin = LEFT_EN; pin <= RIGHT_2; ++pin) pinMode(pin, OUTPUT);
  pinMode(LEFT_ENCODER, INPUT_PULLUP);
  pinMode(RIGHT_ENCODER, INPUT_PULLUP);
  attachInterrupt(digitalPinToInterrupt(LEFT_ENCODER), onLeft, CHANGE);
  attachInterrupt(digitalPinToInterrupt(RIGHT_ENCODER), onRight, CHANGE);
}

void loop() {
  leg(1);
  leg(-1);
}
