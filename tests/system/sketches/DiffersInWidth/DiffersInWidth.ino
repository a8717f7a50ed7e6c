// 160 * 250 is 40000: too much for an int of 16 bits.
volatile int wheel = 160, turns = 250;

void report() {
  int path = wheel * turns;
  Serial.print("path ");
  Serial.println(path);
}

void setup() {
  Serial.begin(115200);
  Serial.println("hello");
  report();
}

void loop() { delay(10); }
