// Waits by counting, so the slower the chip, the longer the wait.
void waitByCounting() {
  for (volatile long i = 0; i < 900000; ++i) {
  }
}

void setup() {
  Serial.begin(115200);
  Serial.println("waiting");
  waitByCounting();
  Serial.println("waited");
}

void loop() { delay(10); }
