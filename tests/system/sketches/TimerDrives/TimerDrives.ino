// A timer interrupt at 100 Hz does everything: it drives for three seconds, stops, and prints a line.
volatile int left = 300;

ISR(TIMER1_COMPA_vect) {
  if (left == 300) analogWrite(5, 60), analogWrite(6, 60);
  if (left > 0 && --left == 0) {
    analogWrite(5, 0);
    analogWrite(6, 0);
    Serial.println("drove");
  }
}

void setup() {
  Serial.begin(9600);
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  noInterrupts();
  TCCR1A = 0;
  TCCR1B = _BV(WGM12) | _BV(CS12);
  OCR1A = F_CPU / 256 / 100 - 1;
  TIMSK1 = _BV(OCIE1A);
  interrupts();
}

void loop() {}
