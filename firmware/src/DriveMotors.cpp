#include "DriveMotors.h"

void DriveMotor::begin() {
  if (enable_ != kNoPin) pinMode(enable_, OUTPUT);
  pinMode(in1_, OUTPUT);
  pinMode(in2_, OUTPUT);
  drive(0);
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
  const uint8_t duty = dutyFor(static_cast<uint8_t>(size), smallest_);
  if (enable_ != kNoPin) {
    digitalWrite(in1_, forward ? HIGH : LOW);
    digitalWrite(in2_, backward ? HIGH : LOW);
    analogWrite(enable_, duty);
  } else {
    analogWrite(in1_, forward ? duty : 0);
    analogWrite(in2_, backward ? duty : 0);
  }
}

void DriveMotor::brake() {
  digitalWrite(in1_, HIGH);
  digitalWrite(in2_, HIGH);
  if (enable_ != kNoPin) digitalWrite(enable_, HIGH);
}

void DriveMotors::begin() {
  left_.begin();
  right_.begin();
  if (standby_ != DriveMotor::kNoPin) {
    pinMode(standby_, OUTPUT);
    digitalWrite(standby_, HIGH);
  }
}
