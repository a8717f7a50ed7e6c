/*
 * Lab 4: dead reckoning. Drives a square of 50 cm by wheel encoders,
 * without floor sensors.
 */
const byte PWM_L = 10, DIR_L = 12;
const byte PWM_R = 11, DIR_R = 13;
const byte ENC_L = 2, ENC_R = 3;
const byte BTN = 8;

const float WHEEL_DIAMETER = 65.0;   // mm
const float WHEEL_BASE = 130.0;      // mm
const int TICKS_PER_REV = 40;        // both edges of a disc with 20 slots
const float MM_PER_TICK = PI * WHEEL_DIAMETER / TICKS_PER_REV;

volatile long ticksL = 0;
volatile long ticksR = 0;

void countL() { ticksL++; }
void countR() { ticksR++; }

long readTicks(volatile long &t) {
  noInterrupts();
  long copy = t;
  interrupts();
  return copy;
}

void setMotors(int l, int r) {
  digitalWrite(DIR_L, l >= 0 ? HIGH : LOW);
  digitalWrite(DIR_R, r >= 0 ? HIGH : LOW);
  analogWrite(PWM_L, abs(l));
  analogWrite(PWM_R, abs(r));
}

// Drives until both wheels have turned by `ticks`. The wheel that is ahead gets less power.
void drive(long ticks, int signL, int signR) {
  noInterrupts();
  ticksL = ticksR = 0;
  interrupts();
  while (true) {
    long l = readTicks(ticksL), r = readTicks(ticksR);
    if (l >= ticks && r >= ticks) break;
    long left = ticks - min(l, r);
    int base = left < 12 ? 85 : 120;
    int fix = constrain((l - r) * 12, -40, 40);
    setMotors(l >= ticks ? 0 : signL * (base - fix), r >= ticks ? 0 : signR * (base + fix));
  }
  setMotors(-signL * 90, -signR * 90);   // brake
  delay(25);
  setMotors(0, 0);
  delay(300);
}

void setup() {
  pinMode(PWM_L, OUTPUT);
  pinMode(DIR_L, OUTPUT);
  pinMode(PWM_R, OUTPUT);
  pinMode(DIR_R, OUTPUT);
  pinMode(ENC_L, INPUT_PULLUP);
  pinMode(ENC_R, INPUT_PULLUP);
  pinMode(BTN, INPUT_PULLUP);
  attachInterrupt(digitalPinToInterrupt(ENC_L), countL, CHANGE);
  attachInterrupt(digitalPinToInterrupt(ENC_R), countR, CHANGE);
  Serial.begin(115200);
  Serial.print("mm per tick: ");
  Serial.println(MM_PER_TICK, 3);
  while (digitalRead(BTN) == HIGH) {
    // wait for the button
  }
  delay(500);
}

int side = 0;

void loop() {
  if (side == 4) {
    Serial.println("done");
    while (1);
  }
  drive(lround(500.0 / MM_PER_TICK), 1, 1);
  drive(lround(WHEEL_BASE * PI / 4 / MM_PER_TICK), -1, 1);
  side++;
  Serial.print("corner ");
  Serial.println(side);
}
