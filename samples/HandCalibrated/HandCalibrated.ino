// Club robot with five analog sensors and one button. After the first press, move the robot over the line for
// 4 s. Then put the robot at the start and press again. The robot drives 2 s later.
const byte BTN = 4, LED = 13;
const byte PIN[5] = {A0, A1, A2, A3, A4};
int lo[5], hi[5];
int lastPos = 2000;

void waitForButton() {
  while (digitalRead(BTN) == HIGH) { digitalWrite(LED, millis() / 200 % 2); }
  delay(30);
  while (digitalRead(BTN) == LOW) ;
  delay(30);
}

void calibrate() {
  for (byte i = 0; i < 5; i++) { lo[i] = 1023; hi[i] = 0; }
  unsigned long t0 = millis();
  while (millis() - t0 < 4000) {
    for (byte i = 0; i < 5; i++) {
      int v = analogRead(PIN[i]);
      lo[i] = min(lo[i], v);
      hi[i] = max(hi[i], v);
    }
  }
  bool good = true;
  for (byte i = 0; i < 5; i++) {
    Serial.print(lo[i]); Serial.print('-'); Serial.print(hi[i]); Serial.print(' ');
    if (hi[i] - lo[i] < 300) good = false;
  }
  Serial.println(good ? F("ok") : F("BAD - once more"));
  if (!good) { waitForButton(); calibrate(); }
}

int position() {
  long sum = 0, weighted = 0;
  for (byte i = 0; i < 5; i++) {
    long v = constrain(map(analogRead(PIN[i]), lo[i], hi[i], 0, 1000), 0, 1000);
    if (v < 100) v = 0;
    sum += v;
    weighted += v * i * 1000;
  }
  if (sum == 0) return lastPos < 2000 ? 0 : 4000;
  return lastPos = weighted / sum;
}

void motor(byte en, byte a, byte b, int speed) {
  digitalWrite(a, speed >= 0);
  digitalWrite(b, speed < 0);
  analogWrite(en, min(abs(speed), 255));
}

void setup() {
  Serial.begin(9600);
  for (byte p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  pinMode(LED, OUTPUT);
  pinMode(BTN, INPUT_PULLUP);
  Serial.println(F("press, then sweep me over the line"));
  waitForButton();
  calibrate();
  waitForButton();
  Serial.println(F("hands off!"));
  delay(2000);
}

void loop() {
  static int lastError = 0;
  int error = position() - 2000;
  int turn = error / 16 + (error - lastError) / 4;
  lastError = error;
  motor(5, 7, 8, 90 + turn);
  motor(6, 9, 10, 90 - turn);
}
