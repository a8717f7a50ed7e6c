// Attaches an interrupt to the digital sensor on pin 3, which stays over the line. Prints the number of
// edges, which is 0.
volatile int edges = 0;

void onEdge() { edges++; }

void setup() {
  Serial.begin(9600);
  delay(20);
  attachInterrupt(digitalPinToInterrupt(3), onEdge, RISING);
  delay(20);
  Serial.println(edges);
}

void loop() { delay(10); }
