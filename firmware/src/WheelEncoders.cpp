#include "WheelEncoders.h"

WheelEncoders::Wheel WheelEncoders::left_ = {0, 1};
WheelEncoders::Wheel WheelEncoders::right_ = {0, 1};

void WheelEncoders::begin() {
  pinMode(left_pin_, INPUT_PULLUP);
  pinMode(right_pin_, INPUT_PULLUP);
  attachInterrupt(digitalPinToInterrupt(left_pin_), onLeft, CHANGE);
  attachInterrupt(digitalPinToInterrupt(right_pin_), onRight, CHANGE);
}

void WheelEncoders::setDirections(int16_t left, int16_t right) {
  if (left != 0) left_.step = left < 0 ? -1 : 1;
  if (right != 0) right_.step = right < 0 ? -1 : 1;
}

int16_t WheelEncoders::take(Wheel& wheel) {
  noInterrupts();
  const int16_t counts = wheel.counts;
  wheel.counts = 0;
  interrupts();
  return counts;
}
