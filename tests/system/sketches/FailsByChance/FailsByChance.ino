// Crashes where a noisy reading is odd: with some seeds, and not with others. Else it goes on for ever.
void setup() {
  if (analogRead(A2) % 2 == 1) abort();
}

void loop() { delay(100); }
