// The detectors that examine what firmware does to its board. They work for every target.
#pragma once

#include <vector>

#include "hal/board/robot_port.h"
#include "sim/judge/eeprom_wear.h"
#include "sim/judge/forgotten_output.h"
#include "sim/judge/lost_pwm.h"
#include "sim/judge/overwritten_record.h"
#include "sim/judge/slow_source.h"
#include "sim/judge/torn_record.h"

namespace robosim::run {

class BoardDetectors final : PinWatcher, EepromWatcher, AdcWatcher {
 public:
  /// Attaches to `executor`, which outlives this object. This object must outlive all use of `executor`.
  BoardDetectors(exec::Executor& executor, const std::vector<robot::WiredPin>& wiring);
  BoardDetectors(const BoardDetectors&) = delete;
  BoardDetectors& operator=(const BoardDetectors&) = delete;

  /// Records how often the firmware has started.
  void booted(std::uint64_t times);
  /// Returns the findings at the end of the run. `now` is the present time.
  std::vector<exec::Detected> found(SimTime now) const;

  /// The state that changes during a run.
  struct State {
    std::uint64_t boots = 1;
    judge::EepromWear wear;
    judge::TornRecord records;
    judge::OverwrittenRecord overwritten;
    judge::ForgottenOutput outputs;
    judge::LostPwm pwm;
    judge::SlowSource sources;
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  void eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) override;

  void converted(Pin pin, double volts, SimTime t) override;

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::run
