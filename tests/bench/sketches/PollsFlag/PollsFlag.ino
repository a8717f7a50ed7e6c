// Waits for a flag that a timer's interrupt sets every 10 ms.
volatile bool flag;

ISR(TIMER1_COMPA_vect) { flag = true; }

void setup() {
  pinMode(13, OUTPUT);
  TCCR1A = 0;
  TCCR1B = _BV(WGM12) | _BV(CS11);
  OCR1A = 19999;
  TIMSK1 = _BV(OCIE1A);
}

void loop() {
  while (!flag);
  flag = false;
  PINB = _BV(PB5);
}
