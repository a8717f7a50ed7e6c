// Crashes if a noisy reading is odd, which depends on the seed. Otherwise the sketch runs forever.
void setup() {
  if (analogRead(A2) % 2 == 1) abort();
}

void loop() { delay(100); }
