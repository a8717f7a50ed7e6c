// A mean of no readings: a division by zero, which the host refuses and which gives some number on each chip.
volatile int sum = 512, readings = 0;

int mean() { return sum / readings; }

void setup() {
  Serial.begin(115200);
  Serial.println("hello");
  Serial.println(mean());
}

void loop() { delay(10); }
