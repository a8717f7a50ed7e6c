// Recurses without end: the stack grows into the variables.
volatile int depth;

int __attribute__((noinline)) deeper(int n) {
  volatile char room[8];
  room[0] = n;
  depth = n;
  return deeper(n + 1) + room[0];
}

void setup() {
  delay(20);
  deeper(0);
}

void loop() {}
