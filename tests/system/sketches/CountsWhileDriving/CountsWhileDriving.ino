// Drives until the left encoder has counted enough edges, and reads only the count.
volatile int ticks = 0;

void count() { ticks++; }

void setup() {
  Serial.begin(9600);
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  attachInterrupt(digitalPinToInterrupt(2), count, CHANGE);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  analogWrite(5, 60);
  analogWrite(6, 60);
  int seen;
  do {
    noInterrupts();
    seen = ticks;
    interrupts();
  } while (seen < 1000);
  analogWrite(5, 0);
  analogWrite(6, 0);
  Serial.println("counted");
}

void loop() { delay(10); }
