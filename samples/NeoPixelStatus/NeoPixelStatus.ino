// Drives WS2812 LEDs on pin 8 (PB0) in assembler (16 MHz AVR only): green = straight, red = turning.
#define LEDS 3
uint8_t pixels[3 * LEDS];   // order: green, red, blue

void show() {
  uint8_t* p = pixels;
  uint8_t n = sizeof pixels;
  uint8_t high = PORTB | _BV(0), low = PORTB & ~_BV(0);
  cli();
  while (n--) {
    uint8_t b = *p++;
    for (uint8_t bit = 0; bit < 8; bit++) {
      if (b & 0x80) {
        asm volatile("out %0, %1\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n out %0, %2\n"
                     :: "I"(_SFR_IO_ADDR(PORTB)), "r"(high), "r"(low));
      } else {
        asm volatile("out %0, %1\n nop\n nop\n nop\n nop\n out %0, %2\n nop\n nop\n nop\n nop\n nop\n nop\n"
                     :: "I"(_SFR_IO_ADDR(PORTB)), "r"(high), "r"(low));
      }
      b <<= 1;
    }
  }
  sei();
  delayMicroseconds(300);
}

void colour(uint8_t r, uint8_t g, uint8_t b) {
  for (uint8_t i = 0; i < LEDS; i++) {
    pixels[3 * i] = g;
    pixels[3 * i + 1] = r;
    pixels[3 * i + 2] = b;
  }
  show();
}

void setup() {
  DDRB |= _BV(0);
  pinMode(5, OUTPUT); pinMode(6, OUTPUT); pinMode(7, OUTPUT); pinMode(9, OUTPUT);
  pinMode(2, OUTPUT); pinMode(10, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  colour(0, 0, 32);
  delay(1000);
}

void loop() {
  static uint8_t shown = 255;
  bool l = digitalRead(A0), r = digitalRead(A2);
  digitalWrite(7, !l); digitalWrite(2, l);     // a wheel whose sensor sees black turns backward
  digitalWrite(9, !r); digitalWrite(10, r);
  analogWrite(5, l ? 80 : 115);
  analogWrite(6, r ? 80 : 115);
  uint8_t state = l || r;
  if (state != shown) {
    shown = state;
    if (state) colour(32, 8, 0);
    else colour(0, 32, 0);
  }
}
