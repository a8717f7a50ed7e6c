// A car with Ackermann steering: one motor drives the rear axle, a servo turns the front wheels.
// Timer 1 generates the servo's pulses on pin 9 (OC1A): one every 20 ms, with 2 counts per microsecond. The
// Servo library has the same effect, by steering.attach(9) and steering.writeMicroseconds(us).
#include <avr/io.h>

const uint8_t MOTOR = 5, FORWARD = 7, BACKWARD = 8, SERVO = 9;
const int MIDDLE = 1472;                // us: straight ahead
const int eye[] = {A0, A1, A2, A3, A4};  // left to right
int last = 0;

void steer(int us) { OCR1A = 2 * (MIDDLE + us); }   // us > 0: to the left

void setup() {
  pinMode(FORWARD, OUTPUT);
  pinMode(BACKWARD, OUTPUT);
  pinMode(SERVO, OUTPUT);
  TCCR1A = _BV(COM1A1) | _BV(WGM11);
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS11);
  ICR1 = 39999;
  steer(0);
  delay(300);
  digitalWrite(FORWARD, HIGH);
  analogWrite(MOTOR, 110);
}

void loop() {
  long sum = 0, weighted = 0;
  for (int i = 0; i < 5; i++) {
    long dark = analogRead(eye[i]) - 150;
    if (dark < 0) dark = 0;
    sum += dark;
    weighted += dark * (2 - i) * 100;
  }
  int error = sum > 150 ? weighted / sum : (last > 0 ? 250 : -250);
  steer(constrain(error * 2 + (error - last) * 2, -460, 460));
  last = error;
  delay(20);                            // the servo gets a pulse every 20 ms
}
