#include "DriveMotors.h"

void DriveMotor::begin() {
  if (enable_ != kNoPin) pinMode(enable_, OUTPUT);
  pinMode(in1_, OUTPUT);
  pinMode(in2_, OUTPUT);
  coast();
}

uint8_t DriveMotor::dutyFor(uint8_t speed, uint8_t smallest) {
  if (speed == 0) return 0;
  return static_cast<uint8_t>(smallest + static_cast<uint16_t>(255 - smallest) * speed / 255);
}

void DriveMotor::drive(int16_t speed) {
  if (reversed_) speed = speed < -255 ? 255 : -speed;
  const bool forward = speed > 0;
  const bool backward = speed < 0;
  int16_t size = backward ? -(speed < -255 ? -255 : speed) : speed;
  if (size > 255) size = 255;
  const uint8_t duty = size == 0 ? 255 : dutyFor(static_cast<uint8_t>(size), smallest_);
  if (enable_ != kNoPin) {
    digitalWrite(in1_, backward ? LOW : HIGH);
    digitalWrite(in2_, forward ? LOW : HIGH);
    analogWrite(enable_, duty);
  } else {
    analogWrite(in1_, backward ? 0 : duty);
    analogWrite(in2_, forward ? 0 : duty);
  }
}

void DriveMotor::coast() {
  digitalWrite(in1_, LOW);
  digitalWrite(in2_, LOW);
  if (enable_ != kNoPin) digitalWrite(enable_, LOW);
}

void DriveMotors::begin() {
  left_.begin();
  right_.begin();
  if (standby_ != DriveMotor::kNoPin) {
    pinMode(standby_, OUTPUT);
    digitalWrite(standby_, HIGH);
  }
}
