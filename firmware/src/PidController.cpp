#include "PidController.h"

void PidController::setGains(float kp, float ki, float kd) {
  kp_ = kp;
  ki_ = ki;
  kd_ = kd;
}

void PidController::setLimits(float lowest, float highest) {
  lowest_ = lowest < highest ? lowest : highest;
  highest_ = lowest < highest ? highest : lowest;
}

float PidController::limited(float output) const {
  if (output < lowest_) return lowest_;
  if (output > highest_) return highest_;
  return output;
}

float PidController::update(float error, float dt) {
  if (started_ && dt > 0) slope_ += ((error - last_error_) / dt - slope_) * (dt / (dt + smoothing_));
  last_error_ = error;
  started_ = true;

  const float without_integral = kp_ * error + kd_ * slope_;
  if (dt > 0) {
    const float grown = integral_ + error * dt;
    const float output = without_integral + ki_ * grown;
    const bool past_limit = output > highest_ || output < lowest_;
    const bool further = output > highest_ ? ki_ * error > 0 : ki_ * error < 0;
    if (!past_limit || !further) integral_ = grown;
  }
  return limited(without_integral + ki_ * integral_);
}

void PidController::reset() {
  integral_ = 0;
  last_error_ = 0;
  slope_ = 0;
  started_ = false;
}
