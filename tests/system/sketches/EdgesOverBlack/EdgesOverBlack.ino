// Attaches an interrupt to the digital sensor on pin 3, which looks at the line all the time, and says how many
// edges it has met: none.
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
