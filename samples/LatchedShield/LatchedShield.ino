// Motor shield v1 (the blue one with two L293D and a 74HC595), driven without the AFMotor library.
// M1 = left, M2 = right
#define MOTORLATCH  12
#define MOTORCLK    4
#define MOTORENABLE 7
#define MOTORDATA   8
#define PWM_M1      11
#define PWM_M2      3

// bits of the 74HC595
#define M1_A 2
#define M1_B 3
#define M2_A 1
#define M2_B 4

uint8_t latch_state = 0;

void latch_tx() {
  digitalWrite(MOTORLATCH, LOW);
  shiftOut(MOTORDATA, MOTORCLK, MSBFIRST, latch_state);
  digitalWrite(MOTORLATCH, HIGH);
}

void motor(int a, int b, int pwmPin, int speed) {
  uint8_t before = latch_state;
  bitWrite(latch_state, a, speed > 0);
  bitWrite(latch_state, b, speed < 0);
  if (latch_state != before) latch_tx();
  analogWrite(pwmPin, abs(speed));
}

void setup() {
  pinMode(MOTORLATCH, OUTPUT);
  pinMode(MOTORENABLE, OUTPUT);
  pinMode(MOTORDATA, OUTPUT);
  pinMode(MOTORCLK, OUTPUT);
  pinMode(PWM_M1, OUTPUT);
  pinMode(PWM_M2, OUTPUT);
  latch_tx();
  digitalWrite(MOTORENABLE, LOW);
}

void loop() {
  int left = analogRead(A0), right = analogRead(A5);    // the shield leaves only A0 to A5, 2 and 13 free
  if (left > 500 && right < 500) {
    motor(M1_A, M1_B, PWM_M1, -120);
    motor(M2_A, M2_B, PWM_M2, 180);
  } else if (right > 500 && left < 500) {
    motor(M1_A, M1_B, PWM_M1, 180);
    motor(M2_A, M2_B, PWM_M2, -120);
  } else {
    motor(M1_A, M1_B, PWM_M1, 150);
    motor(M2_A, M2_B, PWM_M2, 150);
  }
}
