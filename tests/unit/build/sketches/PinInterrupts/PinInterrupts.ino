// Counts encoder edges with attachInterrupt() and with a pin-change interrupt.
const byte encoder = 2;
volatile long left = 0, right = 0;

void setup() {
  pinMode(encoder, INPUT_PULLUP);
  attachInterrupt(digitalPinToInterrupt(encoder), count, RISING);
  attachInterrupt(1, []() { right++; }, CHANGE);
  PCICR |= (1 << PCIE2);
  PCMSK2 |= bit(PCINT20);
  *digitalPinToPCMSK(8) |= bit(digitalPinToPCMSKbit(8));
  EICRA |= _BV(ISC01);
  EIMSK |= _BV(INT0);
}

void count() { left++; }

ISR(PCINT2_vect) { right += PIND >> 4 & 1; }

void loop() {
  noInterrupts();
  long l = left;
  interrupts();
  if (l > 100) detachInterrupt(digitalPinToInterrupt(encoder));
  tone(9, 440, 200);
  noTone(9);
  unsigned long echo = pulseIn(4, HIGH, 30000UL);
  shiftOut(11, 12, MSBFIRST, word(1, 2));
  analogReference(DEFAULT);
  randomSeed(analogRead(A5) + random(10) + random(5, 7) + echo);
}
