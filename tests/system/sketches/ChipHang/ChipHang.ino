// Waits for a flag that no handler sets, with the motors on. Timer 0 keeps interrupting.
volatile bool ready;

void wait() {
  while (!ready) {
  }
}

void setup() {
  for (byte pin = 4; pin <= 9; ++pin) {
    pinMode(pin, OUTPUT);
    digitalWrite(pin, HIGH);
  }
  delay(20);
  wait();
}

void loop() {}
