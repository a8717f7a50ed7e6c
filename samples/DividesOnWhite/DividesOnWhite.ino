// Steers by a weighted average of the sensors. Intentional bug: divides by 0 if no sensor sees the line.
int values[5];
void setup() {
  for (int i = 5; i <= 10; i++) pinMode(i, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  Serial.begin(9600);
}
void loop() {
  int sum = 0, weighted = 0;
  for (int i = 0; i < 5; i++) {
    values[i] = analogRead(i) > 500;
    sum += values[i];
    weighted += values[i] * i * 10;
  }
  int position = weighted / sum - 20;
  analogWrite(5, constrain(90 + position * 4, 0, 255));
  analogWrite(6, constrain(90 - position * 4, 0, 255));
  if (millis() > 2000 && millis() < 2010) Serial.println(position);
}
