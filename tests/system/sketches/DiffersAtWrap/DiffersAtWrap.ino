// Waits three seconds, unless millis() wraps meanwhile (--clock 4294966s).
void waitThreeSeconds() {
  const unsigned long until = millis() + 3000;
  while (millis() < until) delay(1);
}

void setup() {
  Serial.begin(115200);
  Serial.println("waiting");
  waitThreeSeconds();
  Serial.println("three seconds later");
}

void loop() { delay(10); }
