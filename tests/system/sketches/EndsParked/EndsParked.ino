// Stops for good with the motors off.
void setup() { pinMode(13, OUTPUT); }

void loop() {
  digitalWrite(13, HIGH);
  for (;;);
}
