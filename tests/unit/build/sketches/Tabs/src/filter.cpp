#include "filter.h"

#include <Arduino.h>

float Filter::next(float value) {
  state_ += weight_ * (value - state_);
  return constrain(state_, 0, 1023);
}
