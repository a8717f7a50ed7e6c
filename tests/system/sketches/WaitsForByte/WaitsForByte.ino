// Waits for a line from the computer, and reads only Serial's buffer meanwhile.
void setup() {
  Serial.begin(9600);
  while (!Serial.available());
  Serial.println("heard");
}

void loop() { delay(10); }
