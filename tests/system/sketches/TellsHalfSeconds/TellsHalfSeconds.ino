// Prints the time in half seconds. The number depends on a tick of millis(), and on the duration of printing.
void setup() { Serial.begin(9600); }

void loop() {
  Serial.print("Half seconds that have passed: ");
  Serial.println(millis() / 500);
  delay(500);
}
