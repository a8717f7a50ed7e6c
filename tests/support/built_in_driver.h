// Provides a line follower that drives the board directly, without a sketch. Its runs depend only on Robosim,
// so they are bit-identical for every compiler and machine. A sketch's runs also depend on the code that gcc
// generates.
#pragma once

#include "tests/support/fake_firmware.h"

namespace robosim::test {

/// Drives an uno5 (pins: docs/reference/robots.md) with a proportional-derivative controller on five analog
/// sensors.
class BuiltInDriver : public FakeFirmware {
 public:
  /// `period` is the simulated time between two reads of all sensors.
  explicit BuiltInDriver(SimTime period = 5 * kMillisecond) : period_(period) {}

  void power_on(SimTime t) override;
  void run_until(SimTime t) override;
  SimTime sleeps_until() const override { return next_; }
  SimTime last_call() const override { return next_; }

 private:
  void look_and_steer(SimTime t);
  void motor(const Pin* pins, double command, SimTime t);

  SimTime period_;
  SimTime next_ = 0;
  double last_error_ = 0.0;
};

}  // namespace robosim::test
