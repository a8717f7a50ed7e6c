// Drives until a box or wall stalls the motors, then backs off and turns. An ACS712-05B measures the current.
// A divider of 10k and 5k6 on A7 (Nano) measures the battery.
const int CURRENT = A6, BATTERY = A7;
const float VOLTS_PER_AMP = 0.185;
int zero;
#define L1 3
#define L2 5
#define R1 6
#define R2 9

float amps() {
  long sum = 0;
  for (int i = 0; i < 16; i++) sum += analogRead(CURRENT);
  return (sum / 16.0 - zero) * 5.0 / 1023 / VOLTS_PER_AMP;
}

void drive(int l, int r) {
  analogWrite(L1, l > 0 ? l : 0);
  analogWrite(L2, l < 0 ? -l : 0);
  analogWrite(R1, r > 0 ? r : 0);
  analogWrite(R2, r < 0 ? -r : 0);
}

void setup() {
  Serial.begin(9600);
  long sum = 0;
  for (int i = 0; i < 64; i++) sum += analogRead(CURRENT);
  zero = sum / 64;
  Serial.print("battery ");
  Serial.print(analogRead(BATTERY) * 5.0 / 1023 * (10 + 5.6) / 5.6, 1);
  Serial.println(" V");
  delay(500);
}

void loop() {
  drive(180, 180);
  delay(300);                       // ignores the starting current
  while (amps() < 1.6) delay(10);
  drive(0, 0);
  Serial.println("stalled");
  delay(100);
  drive(-180, -180);
  delay(700);
  drive(150, -150);
  delay(450);
}
