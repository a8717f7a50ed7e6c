struct Reading { int value; };

Reading* latest = NULL;

void report() {
  latest->value = analogRead(A0);
}

void setup() {}

void loop() {
  delay(100);
  report();
}
