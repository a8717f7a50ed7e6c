// Two continuous-rotation servos drive the wheels. Timer 1 generates their pulses: OC1A = 9, OC1B = 10.
// ICR1 = 39999 gives a period of 20 ms at 16 MHz / 8, which is 2 counts per microsecond.
#include <avr/io.h>

#define STOP_L 3000
#define STOP_R 3000
const uint8_t eyeL = A1, eyeM = A2, eyeR = A3;

void wheels(int16_t l, int16_t r) {     // -1000 ... 1000
  OCR1A = STOP_L + l;
  OCR1B = STOP_R - r;                   // mounted the other way round
}

void setup() {
  DDRB |= _BV(DDB1) | _BV(DDB2);
  TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(WGM11);
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS11);
  ICR1 = 39999;
  wheels(0, 0);
  delay(500);
}

void loop() {
  bool l = digitalRead(eyeL), r = digitalRead(eyeR);
  if (l == r) wheels(600, 600);
  else if (l) wheels(-100, 600);
  else wheels(600, -100);
}
