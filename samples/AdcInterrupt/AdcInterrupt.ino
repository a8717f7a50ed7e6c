// The ADC converts continuously. Its interrupt handler cycles through the channels; loop() reads the samples.
volatile uint8_t sample[5];
volatile uint8_t channel = 0, rounds = 0;

ISR(ADC_vect) {
  static uint8_t settle = 0;
  if (settle) {                 // the first conversion after a change still uses the old channel
    settle--;
    return;
  }
  sample[channel] = ADCH;       // left-adjusted: the upper 8 bits
  if (++channel == 5) {
    channel = 0;
    rounds++;
  }
  ADMUX = _BV(REFS0) | _BV(ADLAR) | channel;
  settle = 1;
}

void setup() {
  for (uint8_t p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  ADMUX = _BV(REFS0) | _BV(ADLAR);
  ADCSRB = 0;
  ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADATE) | _BV(ADIE) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
}

void loop() {
  static uint8_t seen = 0;
  static int before = 0;
  if (rounds == seen) return;
  seen = rounds;
  int sum = 1, weighted = 0;
  for (uint8_t i = 0; i < 5; i++) {
    int v = sample[i] > 30 ? sample[i] - 30 : 0;
    sum += v;
    weighted += v * (i * 4 - 8);
  }
  int where = (long)weighted * 8 / sum;
  int turn = where * 2 + (where - before) * 8;
  before = where;
  analogWrite(5, constrain(100 + turn, 0, 255));
  analogWrite(6, constrain(100 - turn, 0, 255));
}
