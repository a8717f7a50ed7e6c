// Reads the stack pointer, which the host does not have. Counting takes a different time on each chip.
#ifdef SP  // not defined on the Blue Pill
unsigned int top() { return SP; }
#else
unsigned int top() { return 0; }
#endif

void setup() {
  Serial.begin(115200);
  const bool isThere = top() < 65535;
  Serial.println("waiting");
  for (volatile long i = 0; i < 900000; ++i) {
  }
  Serial.println(isThere ? "waited" : "no stack");
}

void loop() { delay(10); }
