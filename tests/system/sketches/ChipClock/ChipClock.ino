// Checks by a correct and a wrong comparison whether 100 ms have passed, although they have not. The results
// differ if millis() is about to wrap.
void setup() {
  Serial.begin(115200);
  for (int round = 0; round < 5; ++round) {
    unsigned long began = millis();
    unsigned long end = began + 100;
    Serial.print(millis() - began >= 100);
    Serial.print(millis() >= end);
    delay(90);
  }
  Serial.println();
}

void loop() { delay(1000); }
