// Nano with eight analog sensors (A0 to A7) and a TB6612. Drives faster while the error is small (straights).
#define NUM_SENSORS 8
int sensorPin[NUM_SENSORS] = {0, 1, 2, 3, 4, 5, 6, 7};   // analogRead(0) is analogRead(A0)
float Kp = 0.045, Kd = 0.35;
int lastError;
#define ain1 4
#define ain2 3
#define bin1 6
#define bin2 7
#define pwmA 5
#define pwmB 10
#define stby 9
void setup() {
  pinMode(ain1, OUTPUT); pinMode(ain2, OUTPUT); pinMode(bin1, OUTPUT); pinMode(bin2, OUTPUT);
  pinMode(pwmA, OUTPUT); pinMode(pwmB, OUTPUT); pinMode(stby, OUTPUT);
  digitalWrite(stby, HIGH);
  analogReference(DEFAULT);
}
void loop() {
  unsigned long sumWeighted = 0;
  unsigned int sum = 0;
  for (int i = 0; i < NUM_SENSORS; i++) {
    unsigned int v = 1023 - analogRead(sensorPin[i]);    // these modules read less over black
    if (v < 300) v = 0;
    sumWeighted += (unsigned long)v * i * 1000;
    sum += v;
  }
  int position = sum ? sumWeighted / sum : (lastError > 0 ? 7000 : 0);
  int error = position - 3500;
  int adjust = Kp * error + Kd * (error - lastError);
  lastError = error;
  int base = abs(error) < 500 ? 130 : 100;
  set(ain1, ain2, pwmA, base + adjust);
  set(bin1, bin2, pwmB, base - adjust);
}
void set(int in1, int in2, int pwm, int v) {
  digitalWrite(in1, v > 0);
  digitalWrite(in2, v < 0);
  analogWrite(pwm, constrain(abs(v), 0, 255));
}
