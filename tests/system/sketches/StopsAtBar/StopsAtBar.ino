// Follows a line up to a bar that darkens all sensors. A letter on the serial line selects when it stops:
//   o  as soon as all sensors are dark  b  after all were dark for 30 ms
const byte PIN[5] = {A0, A1, A2, A3, A4};
char way;

void drive(int left, int right) {
  digitalWrite(7, left > 0);
  digitalWrite(9, right > 0);
  analogWrite(5, left);
  analogWrite(6, right);
}

void setup() {
  for (byte pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  Serial.begin(115200);
  while (!Serial.available()) {}
  way = Serial.read();
}

void loop() {
  static unsigned long bright = 0;
  int dark = 0, weighted = 0;
  for (byte i = 0; i < 5; i++)
    if (analogRead(PIN[i]) > 511) {
      dark++;
      weighted += i - 2;
    }
  if (dark < 5) bright = millis();
  if (way == 'o' ? dark == 5 : millis() - bright >= 30) {
    drive(0, 0);
    Serial.println(F("bar"));
    for (;;) delay(100);
  }
  drive(60 + 8 * weighted, 60 - 8 * weighted);
}
