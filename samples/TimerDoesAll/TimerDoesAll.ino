// Everything happens in the interrupt of timer 1, 200 times a second. loop() has nothing to do.
#include <avr/interrupt.h>

#define LEFT_PWM   6
#define LEFT_A     7
#define LEFT_B     8
#define RIGHT_PWM  5
#define RIGHT_A    4
#define RIGHT_B    9

static const uint8_t sensorPins[5] = {A4, A3, A2, A1, A0};  // the array is mounted the other way round
static volatile int16_t lastError = 0;

static int16_t lineError() {
  int32_t sum = 0;
  int16_t total = 0;
  for (uint8_t i = 0; i < 5; i++) {
    int16_t v = analogRead(sensorPins[i]) - 150;
    if (v < 0) v = 0;
    sum += (int32_t)v * (i * 100 - 200);
    total += v;
  }
  if (total < 200) return lastError > 0 ? 250 : -250;
  return sum / total;
}

static void motor(uint8_t pwm, uint8_t a, uint8_t b, int16_t speed) {
  digitalWrite(a, speed >= 0);
  digitalWrite(b, speed < 0);
  if (speed < 0) speed = -speed;
  analogWrite(pwm, speed > 255 ? 255 : speed);
}

ISR(TIMER1_COMPA_vect) {
  int16_t error = lineError();
  int16_t turn = error / 2 + (error - lastError) * 2;
  lastError = error;
  motor(LEFT_PWM, LEFT_A, LEFT_B, 90 + turn);
  motor(RIGHT_PWM, RIGHT_A, RIGHT_B, 90 - turn);
}

void setup() {
  for (uint8_t p = 4; p <= 9; p++) pinMode(p, OUTPUT);
  cli();
  TCCR1A = 0;
  TCCR1B = _BV(WGM12) | _BV(CS11) | _BV(CS10);  // CTC, 16 MHz / 64
  OCR1A = 1249;                                 // 5 ms
  TIMSK1 = _BV(OCIE1A);
  sei();
}

void loop() {
}
