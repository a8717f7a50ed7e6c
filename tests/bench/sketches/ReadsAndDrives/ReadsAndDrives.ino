// Only reads sensors and drives, as fast as the Uno can.
const int SENSORS[] = {A0, A1, A2, A3, A4};

void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
}

void loop() {
  long weighted = 0, sum = 0;
  for (int i = 0; i < 5; i++) {
    int dark = analogRead(SENSORS[i]) - 100;
    if (dark < 0) dark = 0;
    weighted += (long)dark * (i - 2) * 60;
    sum += dark;
  }
  int steering = sum > 100 ? weighted / sum : 0;
  analogWrite(5, constrain(120 + steering, 0, 255));
  analogWrite(6, constrain(120 - steering, 0, 255));
}
