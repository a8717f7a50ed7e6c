// Writes beyond the chip's memory.
volatile byte table[4];

void put(unsigned index) { table[index] = 1; }

void setup() {
  delay(20);
  volatile unsigned wrong = 30000;
  put(wrong);
}

void loop() {}
