// Prints a line and then does nothing.
void setup() {
  Serial.begin(9600);
  Serial.println("done");
}

void loop() {}
