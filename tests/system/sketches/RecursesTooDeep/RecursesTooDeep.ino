int depth(volatile int* n) {
  volatile int here = *n + 1;
  return depth(&here) + 1;
}

void setup() { Serial.begin(9600); }

void loop() {
  volatile int zero = 0;
  Serial.println(depth(&zero));
}
