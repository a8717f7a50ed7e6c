// Counts an encoder's edges in a handler, and correctly reads the count with interrupts disabled.
volatile long edges = 0;
void edge() { edges++; }

long counted() {
  noInterrupts();
  long now = edges;
  interrupts();
  return now;
}

void setup() {
  Serial.begin(9600);
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  attachInterrupt(digitalPinToInterrupt(2), edge, RISING);
  digitalWrite(7, HIGH);
  digitalWrite(10, HIGH);
  analogWrite(5, 60);
  analogWrite(6, 60);
  while (counted() < 1500) {
  }
  analogWrite(5, 0);
  analogWrite(6, 0);
  Serial.println("counted");
}

void loop() { delay(100); }
