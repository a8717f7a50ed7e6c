#include "RobotMotor.h"

RobotMotor::RobotMotor(uint8_t pwm, uint8_t direction) : pwm_(pwm), direction_(direction) {}

void RobotMotor::begin() {
  pinMode(pwm_, OUTPUT);
  pinMode(direction_, OUTPUT);
  blinks = 0;
}

void RobotMotor::set(int speed) {
  digitalWrite(direction_, speed < 0);
  analogWrite(pwm_, abs(speed));
}
