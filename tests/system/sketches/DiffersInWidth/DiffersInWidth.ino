// Computes 160 * 250 = 40000, which does not fit a 16-bit int.
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
