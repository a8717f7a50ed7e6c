// A classic bug: no sensor sees the line, and the weighted position is divided by the sum of the readings, 0.
int position(int left, int right) {
  return (0 * left + 1000 * right) / (left + right);
}

void setup() { Serial.begin(9600); }

void loop() {
  Serial.println(position(analogRead(A0) / 2000, 0));
}
