// Which second it is hangs on a tick of millis(), on each target alike. What 7 / 0 is does not.
volatile int nothing = 0;

void setup() { Serial.begin(115200); }

void loop() {
  const unsigned long second = millis() / 1000;
  Serial.println(second % 2 ? "odd" : "even");
  if (second == 5) Serial.println(7 / nothing);
  delay(1000);
}
