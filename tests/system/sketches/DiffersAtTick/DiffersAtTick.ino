// A tick of millis() decides whether a target prints "odd" or "even". No tick changes the value of 7 / 0.
volatile int nothing = 0;

void setup() { Serial.begin(115200); }

void loop() {
  const unsigned long second = millis() / 1000;
  Serial.println(second % 2 ? "odd" : "even");
  if (second == 5) Serial.println(7 / nothing);
  delay(1000);
}
