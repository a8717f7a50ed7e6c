// Follows the right-hand wall by a Sharp GP2Y0A21 (A0), which points right. An IR switch (pin 2) is in front.
#define PWM1 10
#define DIR1 12
#define PWM2 9
#define DIR2 8
float distance() {
  int v = 0;
  for (byte i = 0; i < 4; i++) v += analogRead(A0);
  float volts = v / 4 * 5.0 / 1023.0;
  return 27.728 * pow(volts, -1.2045);       // cm; formula from a forum
}
void motors(int l, int r) {
  digitalWrite(DIR1, l < 0 ? LOW : HIGH);
  digitalWrite(DIR2, r < 0 ? LOW : HIGH);
  analogWrite(PWM1, abs(l));
  analogWrite(PWM2, abs(r));
}
void setup() {
  pinMode(PWM1, OUTPUT); pinMode(PWM2, OUTPUT); pinMode(DIR1, OUTPUT); pinMode(DIR2, OUTPUT);
  pinMode(2, INPUT_PULLUP);
  Serial.begin(9600);
}
void loop() {
  if (digitalRead(2) == LOW) {               // turns left while a wall is ahead
    motors(-110, 110);
    delay(50);
    return;
  }
  float d = distance();
  float error = constrain(d, 8, 40) - 18;
  static float last = 0;
  float turn = 1.8 * error + 14 * (error - last);
  last = error;
  motors(constrain(130 + turn, 60, 200), constrain(130 - turn, 60, 200));
  delay(40);
}
