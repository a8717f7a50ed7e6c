// Computes a mean of no readings: a division by zero. The host refuses it; each chip computes some number.
volatile int sum = 512, readings = 0;

int mean() { return sum / readings; }

void setup() {
  Serial.begin(115200);
  Serial.println("hello");
  Serial.println(mean());
}

void loop() { delay(10); }
