// Shows the number of crossings on a 7-segment digit (common cathode), with segments a to g on pins 2 to 8. A
// DRV8833 drives the motors: right on pins 9/10, left on 11/12. Of these four pins, only 12 has no PWM.
const byte digits[10] = {B0111111, B0000110, B1011011, B1001111, B1100110,
                         B1101101, B1111101, B0000111, B1111111, B1101111};
byte count = 0;

void show(byte n) {
  for (byte i = 0; i < 7; i++) digitalWrite(2 + i, bitRead(digits[n], i));
}

void setup() {
  for (byte p = 2; p <= 12; p++) pinMode(p, OUTPUT);
  show(0);
}

void forward(byte pinA, byte pinB, byte speed) {
  if (speed) analogWrite(pinA, speed);
  else digitalWrite(pinA, HIGH);      // both inputs high: brake
  digitalWrite(pinB, speed ? LOW : HIGH);
}

void loop() {
  static bool was = false;
  bool l = digitalRead(A0), m = digitalRead(A1), r = digitalRead(A2);
  bool crossing = l && m && r;
  if (crossing && !was && count < 9) show(++count);
  was = l || r ? was || crossing : false;
  if (crossing || l == r) {
    forward(11, 12, 50);
    forward(10, 9, 50);
  } else {
    forward(11, 12, l ? 0 : 60);
    forward(10, 9, r ? 0 : 60);
  }
}
