// Prints uninitialised memory: values that earlier calls left on the stack. Their places differ by target.
void __attribute__((noinline)) leaveNumbers() {
  volatile int left[8];
  for (int i = 0; i < 8; ++i) left[i] = 1000 * i;
}

void __attribute__((noinline)) printWhatIsThere() {
  volatile int found[8];
  Serial.println(found[3]);
}

void setup() {
  Serial.begin(115200);
  Serial.println("hello");
  leaveNumbers();
  printWhatIsThere();
}

void loop() { delay(10); }
