// A base class for firmware that a test writes in C++, so that no sketch needs to be compiled.
#pragma once

#include <cmath>
#include <optional>

#include "hal/board/board_spec.h"
#include "sim/exec/core/board_state.h"
#include "sim/exec/core/executor.h"

namespace robosim::test {

/// Firmware that only waits.
class FakeFirmware : public exec::Executor {
 public:
  explicit FakeFirmware(const BoardSpec& board = *find_board("uno")) : board_(board) {}

  RobotPort& board() override { return board_; }
  exec::BoardProbe& probe() override { return board_; }
  void power_on(SimTime) override {}
  void power_off(SimTime t) override { board_.reset(t); }
  void run_until(SimTime t) override { now_ = t; }
  const std::optional<exec::Crash>& crash() const override { return crash_; }
  exec::Activity activity() override { return {}; }
  SimTime last_call() const override { return now_; }

 protected:
  /// Drives the motors of an uno5 with duty cycles from -1 to 1.
  void drive(double left, double right, SimTime t) {
    motor(5, 7, 8, left, t);
    motor(6, 9, 10, right, t);
  }

  exec::BoardState board_;
  SimTime now_ = 0;
  std::optional<exec::Crash> crash_;

 private:
  void motor(Pin enable, Pin in1, Pin in2, double duty, SimTime t) {
    board_.set_drive(enable, {PinMode::output, false, true, std::abs(duty), 0}, t);
    board_.set_drive(in1, {PinMode::output, duty >= 0.0, false, duty >= 0.0 ? 1.0 : 0.0, 0}, t);
    board_.set_drive(in2, {PinMode::output, duty < 0.0, false, duty < 0.0 ? 1.0 : 0.0, 0}, t);
  }
};

}  // namespace robosim::test
