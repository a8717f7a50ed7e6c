// Attaches an interrupt to the digital sensor on pin 3. Because the sensor stays over the line, the sketch
// prints 0 edges.
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
