// Which half second it tells hangs on a tick of millis(), and on what printing costs.
void setup() { Serial.begin(9600); }

void loop() {
  Serial.print("Half seconds that have passed: ");
  Serial.println(millis() / 500);
  delay(500);
}
