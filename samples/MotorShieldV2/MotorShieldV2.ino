#include <Wire.h>

// Uses Adafruit's motor shield v2 without its library: a PCA9685 at 0x60 drives two TB6612.
// M1: PWM 8, IN2 9, IN1 10.  M2: PWM 13, IN2 12, IN1 11.
#define SHIELD 0x60

void writeReg(uint8_t reg, uint8_t value) {
  Wire.beginTransmission(SHIELD);
  Wire.write(reg);
  Wire.write(value);
  Wire.endTransmission();
}

void setPwm(uint8_t channel, uint16_t on, uint16_t off) {
  Wire.beginTransmission(SHIELD);
  Wire.write(0x06 + 4 * channel);
  Wire.write(on);
  Wire.write(on >> 8);
  Wire.write(off);
  Wire.write(off >> 8);
  Wire.endTransmission();
}

void setPin(uint8_t channel, bool high) {
  if (high) setPwm(channel, 4096, 0);
  else setPwm(channel, 0, 0);
}

struct Dc {
  uint8_t pwm, in1, in2;
  int last;
  void run(int speed) {
    if (speed == last) return;
    last = speed;
    setPin(in1, speed > 0);
    setPin(in2, speed < 0);
    setPwm(pwm, 0, abs(speed) * 16);
  }
};
Dc left = {8, 10, 9, 999}, right = {13, 11, 12, 999};

void setup() {
  Wire.begin();
  Wire.setClock(400000L);
  writeReg(0x00, 0x10);          // sleep, to set the prescaler
  writeReg(0xFE, 3);             // 1.6 kHz
  writeReg(0x00, 0x20);          // wake-up, auto-increment
  delay(5);
  left.run(0);
  right.run(0);
}

void loop() {
  // the sensors on A0 and A1 are over the line's edges
  int error = analogRead(A0) - analogRead(A1);
  int turn = error / 8;
  left.run(constrain(90 - turn, -255, 255));
  right.run(constrain(90 + turn, -255, 255));
}
