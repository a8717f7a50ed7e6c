// A tick of millis() decides between "odd" and "even". The value of 7 / 0 depends only on the target.
volatile int nothing = 0;

void setup() { Serial.begin(115200); }

void loop() {
  const unsigned long second = millis() / 1000;
  Serial.println(second % 2 ? "odd" : "even");
  if (second == 5) Serial.println(7 / nothing);
  delay(1000);
}
