// Waits for a line from the computer, by looking at Serial's buffer alone.
void setup() {
  Serial.begin(9600);
  while (!Serial.available());
  Serial.println("heard");
}

void loop() { delay(10); }
