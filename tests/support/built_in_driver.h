// Provides a line follower that drives the board directly, without a sketch. Its runs depend only on Robosim,
// so they are bit-identical for every compiler and machine. A sketch's runs also depend on the code that gcc
// generates.
#pragma once

#include "hal/board/board_spec.h"
#include "sim/exec/core/board_state.h"
#include "sim/exec/core/executor.h"

namespace robosim::test {

/// Drives an uno5 (pins: docs/reference/robots.md) with a proportional-derivative controller on five analog
/// sensors.
class BuiltInDriver final : public exec::Executor {
 public:
  /// `period` is the simulated time between two reads of all sensors.
  explicit BuiltInDriver(SimTime period = 5 * kMillisecond) : period_(period) {}

  RobotPort& board() override { return board_; }
  exec::BoardProbe& probe() override { return board_; }
  void power_on(SimTime t) override;
  void power_off(SimTime t) override { board_.reset(t); }
  void run_until(SimTime t) override;
  SimTime sleeps_until() const override { return next_; }
  const std::optional<exec::Crash>& crash() const override { return crash_; }
  exec::Activity activity() override { return {}; }
  SimTime last_call() const override { return next_; }

 private:
  void look_and_steer(SimTime t);
  void motor(const Pin* pins, double command, SimTime t);

  exec::BoardState board_{*find_board("uno")};
  SimTime period_;
  SimTime next_ = 0;
  double last_error_ = 0.0;
  std::optional<exec::Crash> crash_;
};

}  // namespace robosim::test
