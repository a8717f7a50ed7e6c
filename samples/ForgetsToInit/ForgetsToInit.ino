// Intentional bug: the local variable lastSide is not initialised, so it may contain any value of the stack.
int look() {
  int lastSide;
  bool l = digitalRead(A0), m = digitalRead(A1), r = digitalRead(A2);
  if (l && !r) lastSide = -1;
  if (r && !l) lastSide = 1;
  if (m && !l && !r) lastSide = 0;
  return lastSide;
}
void setup() {
  for (int i = 5; i <= 10; i++) pinMode(i, OUTPUT);
}
void loop() {
  int side = look();
  digitalWrite(7, side != -1); digitalWrite(8, side == -1);
  digitalWrite(9, side != 1);  digitalWrite(10, side == 1);
  analogWrite(5, 100);
  analogWrite(6, 100);
}
