// Waits by counting: as long as the chip is slow.
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
