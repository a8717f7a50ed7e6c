/*
 * Writes a log for `robosim calibrate`: sensor readings while the robot turns slowly on a tape, and encoder
 * counts while the wheels start and coast. docs/howto/calibrating.md explains the procedure.
 *
 * Put the robot on a straight tape, with 1.5 m of free floor. The axle must be over the middle of the tape.
 * Adapt the constants, flash the sketch, and save the serial monitor's text (115200 baud) as log.csv.
 */
const bool HAS_ENCODERS = true;
const byte SENSORS = 5;
const byte SENSOR_PINS[SENSORS] = {A0, A1, A2, A3, A4};
const char SENSOR_NAMES[] = "S1,S2,S3,S4,S5";   // names as in robot.toml
const bool RC_SENSORS = false;                  // true: QTR-RC, timed in microseconds
const unsigned int RC_TIMEOUT_US = 8000;

const byte EN_L = 5, IN1_L = 7, IN2_L = 8;
const byte EN_R = 6, IN1_R = 9, IN2_R = 10;
const byte ENC_L = 2, ENC_R = 3;

const int SWEEP_PWM = 60;              // without encoders: the lowest PWM that keeps the robot turning
const unsigned long SWEEP_MS = 12000;  // without encoders: time in each direction, for more than a turn
const long SWEEP_COUNTS = 3800;        // sum of both wheels' counts: two turns of the robot
const int FAST = 255, SLOW = 140;      // PWM of the drives from rest
const unsigned long FAST_MS = 300, SLOW_MS = 500, ROLL_MS = 700;

volatile long countL = 0, countR = 0;
volatile int signL = 1, signR = 1;     // commanded direction, which a single encoder channel does not show
unsigned long began;

void edgeL() { countL += signL; }
void edgeR() { countR += signR; }

void motor(byte en, byte in1, byte in2, int pwm) {
  digitalWrite(in1, pwm > 0 ? HIGH : LOW);
  digitalWrite(in2, pwm < 0 ? HIGH : LOW);
  analogWrite(en, abs(pwm));           // with all pins low, the motor coasts
}

void drive(int left, int right) {
  if (left) signL = left > 0 ? 1 : -1;
  if (right) signR = right > 0 ? 1 : -1;
  motor(EN_L, IN1_L, IN2_L, left);
  motor(EN_R, IN1_R, IN2_R, right);
}

long counted(volatile long &count) {
  noInterrupts();
  long copy = count;
  interrupts();
  return copy;
}

unsigned long polls;                    // number of times that an RC sensor's pin was still HIGH

unsigned int readSensor(byte pin) {
  if (!RC_SENSORS) return analogRead(pin);
  pinMode(pin, OUTPUT);
  digitalWrite(pin, HIGH);
  delayMicroseconds(10);
  pinMode(pin, INPUT);
  unsigned long start = micros();
  digitalWrite(pin, LOW);
  while (digitalRead(pin) == HIGH && micros() - start < RC_TIMEOUT_US) polls++;
  return micros() - start;
}

void begin() {
  countL = countR = 0;
  began = micros();
}

// Prints a row: time, new motor commands (only in drives), encoder counts, and readings (only in sweeps).
void row(bool sweep, int left, int right) {
  unsigned long t = micros() - began;
  long l = counted(countL), r = counted(countR);
  Serial.print(t);
  if (!sweep) {
    Serial.print(',');
    Serial.print(left);
    Serial.print(',');
    Serial.print(right);
  }
  if (HAS_ENCODERS) {
    Serial.print(',');
    Serial.print(l);
    Serial.print(',');
    Serial.print(r);
  }
  for (byte i = 0; sweep && i < SENSORS; i++) {
    Serial.print(',');
    Serial.print(readSensor(SENSOR_PINS[i]));
  }
  Serial.println();
}

// Waits until no wheel has turned for half a second. Without encoders, waits for half a second.
void rest() {
  long before;
  do {
    before = counted(countL) + 31 * counted(countR);
    delay(500);
  } while (counted(countL) + 31 * counted(countR) != before);
}

// Turns slowly to the left (1) or right (-1). With encoders, uses 7/8 of the PWM at which the wheels start.
void sweep(int way) {
  int left = SWEEP_PWM, right = SWEEP_PWM;
  rest();
  if (HAS_ENCODERS) {
    begin();
    left = right = 10;
    while (left < 255 && right < 255) {
      drive(-way * left, way * right);
      delay(30);
      bool leftTurns = abs(counted(countL)) > 3, rightTurns = abs(counted(countR)) > 3;
      if (leftTurns && rightTurns) break;
      if (!leftTurns) left++;
      if (!rightTurns) right++;
    }
    left -= left / 8;
    right -= right / 8;
  }
  drive(-way * left, way * right);
  delay(500);
  Serial.print(HAS_ENCODERS ? "t_us,count_left,count_right," : "t_us,");
  Serial.println(SENSOR_NAMES);
  begin();
  unsigned long next = 0;
  while (HAS_ENCODERS ? abs(counted(countL)) + abs(counted(countR)) < SWEEP_COUNTS
                      : micros() - began < SWEEP_MS * 1000) {
    if (micros() - began < next) continue;
    row(true, 0, 0);
    next += 5000;
  }
  drive(0, 0);
}

// Drives from rest for `ms` milliseconds, then coasts. Prints a row every 5 ms.
void step(int left, int right, unsigned long ms) {
  rest();
  Serial.println(HAS_ENCODERS ? "t_us,left,right,count_left,count_right" : "t_us,left,right");
  begin();
  drive(left, right);
  row(false, left, right);
  unsigned long next = 5000;
  bool rolls = false;
  while (micros() - began < (ms + ROLL_MS) * 1000) {
    unsigned long t = micros() - began;
    if (!rolls && t >= ms * 1000) {
      rolls = true;
      drive(0, 0);
      row(false, 0, 0);
    } else if (t >= next) {
      row(false, rolls ? 0 : left, rolls ? 0 : right);
      next += 5000;
    }
  }
}

void setup() {
  const byte outputs[] = {EN_L, IN1_L, IN2_L, EN_R, IN1_R, IN2_R};
  for (byte i = 0; i < sizeof(outputs); i++) pinMode(outputs[i], OUTPUT);
  drive(0, 0);
  if (HAS_ENCODERS) {
    pinMode(ENC_L, INPUT_PULLUP);
    pinMode(ENC_R, INPUT_PULLUP);
    attachInterrupt(digitalPinToInterrupt(ENC_L), edgeL, CHANGE);
    attachInterrupt(digitalPinToInterrupt(ENC_R), edgeR, CHANGE);
  }
  Serial.begin(115200);
  Serial.println("# robosim calibration log");
  Serial.println("# counts_per_period = 2");       // both edges of one channel count
  if (RC_SENSORS) {                                // mean time between two reads of a pin
    unsigned long sum = 0;
    for (byte i = 0; i < SENSORS; i++) sum += readSensor(SENSOR_PINS[i]);
    Serial.print("# timing_step_us = ");
    Serial.println((float)sum / polls);
  }
  delay(3000);                                     // time for the user to step back
  sweep(1);
  sweep(-1);
  if (HAS_ENCODERS) {                              // otherwise a stopwatch is needed (calibrating.md)
    step(FAST, FAST, FAST_MS);
    step(-FAST, -FAST, FAST_MS);
    step(SLOW, SLOW, SLOW_MS);
    step(-SLOW, -SLOW, SLOW_MS);
    step(SLOW, -SLOW, SLOW_MS);
    step(-SLOW, SLOW, SLOW_MS);
  }
  Serial.println("# end");
  Serial.flush();
}

void loop() {
}
