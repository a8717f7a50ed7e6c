// Counts all edges of encoders on A2/A3 (left) and 8/9 (right) by pin change interrupts. Goes 30 cm and back.
#include <avr/interrupt.h>

volatile long countL, countR;
const int8_t table[16] PROGMEM = {0, 1, -1, 0, -1, 0, 0, 1, 1, 0, 0, -1, 0, -1, 1, 0};
static uint8_t oldL, oldR;

ISR(PCINT1_vect) {
  oldL = (oldL << 2 | (PINC >> 2 & 3)) & 15;
  countL += (int8_t)pgm_read_byte(&table[oldL]);
}
ISR(PCINT0_vect) {
  oldR = (oldR << 2 | (PINB & 3)) & 15;
  countR += (int8_t)pgm_read_byte(&table[oldR]);
}

const float TICKS_PER_MM = 4 * 154.35 / (PI * 32);

void wheel(uint8_t pwm, uint8_t dir, int v) {
  v = constrain(v, -150, 150);
  if (abs(v) < 25) v = 0;
  digitalWrite(dir, v >= 0 ? HIGH : LOW);
  analogWrite(pwm, abs(v));
}

void moveTo(float mm) {
  long target = lround(mm * TICKS_PER_MM);
  unsigned long quietSince = millis();
  while (millis() - quietSince < 300) {
    noInterrupts();
    long l = countL, r = countR;
    interrupts();
    long el = target - l, er = target - r;
    wheel(3, 2, el / 4 + (r - l) / 8);
    wheel(11, 12, er / 4 - (r - l) / 8);
    if (abs(el) > 110 || abs(er) > 110) quietSince = millis();
  }
  wheel(3, 2, 0);
  wheel(11, 12, 0);
}

void setup() {
  Serial.begin(9600);
  DDRD |= _BV(2) | _BV(3);
  DDRB |= _BV(3) | _BV(4);
  PORTC |= _BV(2) | _BV(3);
  PORTB |= _BV(0) | _BV(1);
  PCMSK1 = _BV(PCINT10) | _BV(PCINT11);
  PCMSK0 = _BV(PCINT0) | _BV(PCINT1);
  PCICR = _BV(PCIE1) | _BV(PCIE0);
  delay(200);
}

void loop() {
  moveTo(300);
  Serial.print("there ");
  Serial.println(countL / 100 * 100);
  moveTo(0);
  Serial.print("back ");
  Serial.println(countL / 100);
  delay(1000);
}
