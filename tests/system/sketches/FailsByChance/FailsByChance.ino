// Crashes if a noisy reading is odd, and runs forever if it is even. The reading depends on the seed.
void setup() {
  if (analogRead(A2) % 2 == 1) abort();
}

void loop() { delay(100); }
