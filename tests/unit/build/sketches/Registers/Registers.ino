// Accesses ports, the ADC and PWM through their registers.
volatile int reading;

void setup() {
  Serial.begin(9600);
  DDRB |= _BV(PB5) | (1 << DDB1);
  DDRD = B01100000;
  PORTD &= ~(_BV(5) | _BV(6));
  PORTB = PORTB | 0x20;
  PORTC |= (1 << PORTC0);
  bitSet(PORTB, 5);
  bitClear(PORTB, 5);
  bitWrite(PORTB, 5, reading > 3);

  ADMUX = (1 << REFS0) | (0 & 0x0F);
  ADCSRA = (1 << ADEN) | (1 << ADPS2) | (1 << ADPS1) | (1 << ADPS0);

  TCCR1A = _BV(COM1A1) | _BV(WGM11);
  TCCR1B = _BV(WGM13) | _BV(CS10);
  ICR1 = 400;
  OCR1A = 100;
  TCCR0B = (TCCR0B & 0b11111000) | 0x02;
}

int adc(byte channel) {
  ADMUX = (ADMUX & 0xF0) | channel;
  ADCSRA |= (1 << ADSC);
  while (ADCSRA & (1 << ADSC))
    ;
  uint8_t low = ADCL;
  return (ADCH << 8) | low;
}

void loop() {
  reading = adc(0) + ADC;
  if (PIND & (1 << PIND2)) PORTB ^= (1 << 5);
  if (!(PIND & 0x04) && bit_is_clear(PINB, 0)) PINB = _BV(5);
  switch (PIND & 0b11) {
    case 0b00:
      OCR1A = 0;
      break;
    case 0b11:
      OCR1A += 10;
      break;
    default:
      OCR1A = min(reading, 399);
  }
  *portOutputRegister(digitalPinToPort(5)) |= digitalPinToBitMask(5);
  Serial.println(PINB, BIN);
}
