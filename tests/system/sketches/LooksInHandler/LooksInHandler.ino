// Reads a pin every 50 us in a handler of timer 2, as an infrared receiver does. loop() waits for the pin.
volatile bool seen = false;
volatile unsigned int times = 0;

ISR(TIMER2_COMPA_vect) {
  if (!(PIND & _BV(4))) seen = true;
  for (byte i = 0; i < 10; i++) times = i;
}

void setup() {
  Serial.begin(9600);
  TCCR2A = _BV(WGM21);
  TCCR2B = _BV(CS21);
  OCR2A = 99;
  TIMSK2 = _BV(OCIE2A);
}

void loop() {
  if (!seen) return;
  Serial.println("seen");
  seen = false;
  delay(1000);
}
