// Follows the line, and waits while something is in the robot's way.
#define trigPin 12
#define echoPin 11
const int ldrLeft = A0, ldrMid = A1, ldrRight = A2;
bool waiting = false;
unsigned long lastPing = 0;
void setup() {
  pinMode(trigPin, OUTPUT);
  pinMode(echoPin, INPUT);
  pinMode(13, OUTPUT);
  for (int i = 5; i < 11; i++) pinMode(i, OUTPUT);
  Serial.begin(9600);
}
long measure() {
  digitalWrite(trigPin, LOW); delayMicroseconds(5);
  digitalWrite(trigPin, HIGH); delayMicroseconds(10);
  digitalWrite(trigPin, LOW);
  return pulseIn(echoPin, HIGH, 4000) / 58;     // timeout 4 ms = 69 cm; 0 = no echo
}
void loop() {
  if (millis() - lastPing > 60) {
    lastPing = millis();
    long cm = measure();
    bool blocked = cm > 0 && cm < 20;
    if (blocked != waiting) {
      waiting = blocked;
      Serial.println(waiting ? "something is in my way" : "free again");
      digitalWrite(13, waiting);
    }
  }
  if (waiting) { go(0, 0); return; }
  bool l = digitalRead(ldrLeft), r = digitalRead(ldrRight);
  if (l) go(-70, 110);
  else if (r) go(110, -70);
  else go(100, 100);
}
void go(int l, int r) {
  digitalWrite(7, l > 0); digitalWrite(8, l < 0); analogWrite(5, abs(l));
  digitalWrite(9, r > 0); digitalWrite(10, r < 0); analogWrite(6, abs(r));
}
