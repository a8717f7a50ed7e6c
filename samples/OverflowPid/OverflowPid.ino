// PD control with an intentional bug: products overflow an Uno's 16-bit int, and the robot leaves the line.
int kp = 30, kd = 200, last = 0;
int read_position() {
  unsigned int weighted = 0, sum = 0;     // 16 bits on an Uno
  for (int i = 0; i < 5; i++) {
    unsigned int v = analogRead(A0 + i);
    weighted += v * (i * 100);
    sum += v;
  }
  return weighted / sum - 200;
}
void setup() {
  for (int i = 5; i <= 10; i++) pinMode(i, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  Serial.begin(9600);
}
void loop() {
  int error = read_position();
  int turn = (error * kp + (error - last) * kd) / 100;
  last = error;
  analogWrite(5, constrain(100 + turn, 0, 255));
  analogWrite(6, constrain(100 - turn, 0, 255));
  delay(5);
}
