// A line that changes its level at known times, such as a serial line or a remote control receiver's output.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hal/board/robot_port.h"

namespace robosim::robot {

/// The future changes, and the level before them, as a copyable value.
class PulseTrain {
 public:
  explicit PulseTrain(bool idle) : before_(idle) {}

  /// Adds a change of the level at `at`, which must not be before the last change.
  void flip(SimTime at) { flips_.push_back(at); }
  /// Returns the time of the last change, or 0.
  SimTime end() const { return empty() ? 0 : flips_.back(); }
  bool level(SimTime t) const { return before_ != (((passed(t) - first_) & 1) != 0); }
  /// Returns the time of the first change after `t`; kNever if the level does not change any more.
  SimTime same_until(SimTime t) const {
    const std::size_t next = passed(t);
    return next < flips_.size() ? flips_[next] : kNever;
  }
  bool empty() const { return first_ == flips_.size(); }
  /// Schedules the edges of the tick that begins at `t` on `pin`, and drops earlier edges.
  void begin_tick(RobotPort& board, Pin pin, SimTime t) {
    before_ = level(t - 1);
    first_ = passed(t - 1);
    if (2 * first_ > flips_.size()) {
      flips_.erase(flips_.begin(), flips_.begin() + static_cast<std::ptrdiff_t>(first_));
      first_ = 0;
    }
    bool now = before_;
    for (std::size_t i = first_; i < flips_.size() && flips_[i] < t + kTick; ++i) {
      now = !now;
      board.schedule_edge(pin, now, flips_[i]);
    }
  }

 private:
  /// Returns the number of elements of flips_ at or before `t`, counted from the first element.
  std::size_t passed(SimTime t) const {
    const auto first = flips_.begin() + static_cast<std::ptrdiff_t>(first_);
    return static_cast<std::size_t>(std::upper_bound(first, flips_.end(), t) - flips_.begin());
  }

  bool before_;  // the level before flips_[first_]
  std::size_t first_ = 0;
  std::vector<SimTime> flips_;
};

}  // namespace robosim::robot
