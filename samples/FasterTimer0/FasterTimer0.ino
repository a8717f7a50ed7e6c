// Sets timer 0 to 62.5 kHz, so that the motors do not whine. millis() and delay() then run 64 times as fast!
#define DELAY(ms) delay((ms) * 64UL)
const int sensors[] = {A0, A1, A2, A3, A4};
int err, olderr;
void setup() {
  TCCR0B = TCCR0B & B11111000 | B00000001;
  for (int i = 5; i <= 10; i++) pinMode(i, OUTPUT);
  digitalWrite(7, 1); digitalWrite(8, 0);
  digitalWrite(9, 1); digitalWrite(10, 0);
  pinMode(13, OUTPUT);
  for (int i = 0; i < 6; i++) {     // blinks three times in 3 s
    digitalWrite(13, !digitalRead(13));
    DELAY(500);
  }
  Serial.begin(9600);
  Serial.println(millis() / 64);
}
void loop() {
  int mask = 0;
  for (int i = 0; i < 5; i++) mask = mask << 1 | (analogRead(sensors[i]) > 512);
  switch (mask) {
    case B00100: err = 0; break;
    case B01100: err = -1; break;
    case B01000: err = -2; break;
    case B11000: err = -3; break;
    case B10000: err = -4; break;
    case B00110: err = 1; break;
    case B00010: err = 2; break;
    case B00011: err = 3; break;
    case B00001: err = 4; break;
  }
  int u = err * 18 + (err - olderr) * 30;
  olderr = err;
  analogWrite(5, constrain(100 + u, 0, 255));
  analogWrite(6, constrain(100 - u, 0, 255));
  DELAY(5);
}
