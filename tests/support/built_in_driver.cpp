#include "tests/support/built_in_driver.h"

#include <algorithm>
#include <cmath>

namespace robosim::test {
namespace {

// The pins EN, IN1 and IN2 of an uno robot's motors, and its leftmost sensor.
constexpr Pin kLeft[] = {5, 7, 8};
constexpr Pin kRight[] = {6, 9, 10};
constexpr Pin kFirstSensor = 14;

constexpr double kCruise = 0.5;  // duty cycle, 0..1
constexpr double kProportional = 0.22;
constexpr double kDerivative = 1.2;

PinDrive level(bool high) { return {PinMode::output, high, false, high ? 1.0 : 0.0, 0}; }

}  // namespace

void BuiltInDriver::power_on(SimTime t) {
  board_.reset(t);
  next_ = t;
  last_error_ = 0.0;
}

void BuiltInDriver::motor(const Pin* pins, double command, SimTime t) {
  board_.set_drive(pins[1], level(command >= 0.0), t);
  board_.set_drive(pins[2], level(command < 0.0), t);
  board_.set_drive(pins[0], {PinMode::output, false, true, std::min(std::abs(command), 1.0), 0}, t);
}

void BuiltInDriver::look_and_steer(SimTime t) {
  double weighted = 0.0, sum = 0.0;
  for (int i = 0; i < 5; ++i) {
    const double dark = std::max(0.0, board_.read_volts(static_cast<Pin>(kFirstSensor + i), t) - 1.0);
    weighted += dark * (2 - i);  // positive: the line is to the left
    sum += dark;
  }
  const double error = sum > 0.5 ? weighted / sum : (last_error_ > 0.0 ? 2.0 : -2.0);
  const double steering = kProportional * error + kDerivative * (error - last_error_);
  last_error_ = error;
  motor(kLeft, kCruise - steering, t);
  motor(kRight, kCruise + steering, t);
}

void BuiltInDriver::run_until(SimTime t) {
  for (; next_ < t; next_ += period_) look_and_steer(next_);
}

}  // namespace robosim::test
