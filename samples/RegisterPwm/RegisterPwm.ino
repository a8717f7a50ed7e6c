// Accesses ports, timer 2 and the ADC by registers, without Arduino functions.
// Motors on OC2A (PB3 = 11) and OC2B (PD3 = 3), directions on PD4..PD7, two sensors on ADC0 and ADC1.

#define PWM_LEFT   OCR2A
#define PWM_RIGHT  OCR2B

static uint16_t adc(uint8_t channel) {
  ADMUX = (1 << REFS0) | channel;
  ADCSRA |= (1 << ADSC);
  while (ADCSRA & (1 << ADSC))
    ;
  return ADC;
}

void setup() {
  DDRB |= (1 << PB3) | (1 << PB5);
  DDRD |= (1 << PD3) | (1 << PD4) | (1 << PD5) | (1 << PD6) | (1 << PD7);

  // phase correct PWM, 490 Hz
  TCCR2A = (1 << COM2A1) | (1 << COM2B1) | (1 << WGM20);
  TCCR2B = (1 << CS22);
  PWM_LEFT = PWM_RIGHT = 0;

  ADCSRA = (1 << ADEN) | (1 << ADPS2) | (1 << ADPS1);  // ADC clock 250 kHz
  PORTD = (PORTD & 0x0F) | B01010000;                  // both motors forward
}

void loop() {
  int16_t diff = (int16_t)adc(0) - (int16_t)adc(1);  // left - right: positive = line is left
  int16_t turn = diff >> 2;
  int16_t left = 100 - turn, right = 100 + turn;

  if (left < 0) { PORTD = (PORTD & ~0x30) | 0x20; left = -left; }
  else          { PORTD = (PORTD & ~0x30) | 0x10; }
  if (right < 0) { PORTD = (PORTD & ~0xC0) | 0x80; right = -right; }
  else           { PORTD = (PORTD & ~0xC0) | 0x40; }

  PWM_LEFT = left > 255 ? 255 : left;
  PWM_RIGHT = right > 255 ? 255 : right;

  if (diff > 300 || diff < -300) PORTB |= (1 << PB5);
  else PORTB &= ~(1 << PB5);
}
