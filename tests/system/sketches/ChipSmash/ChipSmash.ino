// Writes beyond the end of a local array, over its own return address.
char text[24] = "as long as twenty-three";
volatile byte length = 8;

void __attribute__((noinline)) copy() {
  char room[4];
  char* to = room;
  for (byte i = 0; i < length; ++i) to[i] = text[i];
  asm volatile("" : : "r"(to) : "memory");
}

void setup() {
  delay(20);
  copy();
}

void loop() {}
