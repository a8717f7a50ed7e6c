// Has nothing more to do.
void setup() {
  Serial.begin(9600);
  Serial.println("done");
}

void loop() {}
