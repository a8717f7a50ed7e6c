// Paces itself by polling millis(), as "blink without delay" does.
unsigned long last = 0;
bool on = false;

void setup() { pinMode(13, OUTPUT); }

void loop() {
  if (millis() - last >= 10) {
    last += 10;
    on = !on;
    digitalWrite(13, on);
  }
}
