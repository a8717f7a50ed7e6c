// Crashes where a noisy reading is odd: with some seeds, and not with others.
void setup() {
  if (analogRead(A2) % 2 == 1) abort();
}

void loop() {}
