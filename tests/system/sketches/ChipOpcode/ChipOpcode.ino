// Executes an instruction that the chip does not have.
void broken() { asm volatile(".word 0x0001"); }

void setup() {
  delay(20);
  broken();
}

void loop() {}
