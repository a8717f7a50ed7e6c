// Prints half seconds. Their number depends on a tick of millis(), and on the time for printing.
void setup() { Serial.begin(9600); }

void loop() {
  Serial.print("Half seconds that have passed: ");
  Serial.println(millis() / 500);
  delay(500);
}
