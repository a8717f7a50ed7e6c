// Counts resets by the watchdog. An occasional reset is the watchdog's purpose. If the watchdog resets the
// firmware several times in a row, the firmware counts as crashed.
#pragma once

#include <fmt/format.h>

#include <string>

#include "hal/board/sim_time.h"

namespace robosim::exec {

class WatchdogResets {
 public:
  static constexpr int kTooMany = 3;
  static constexpr SimTime kRow = 10 * kSecond;  ///< longest time between successive resets in a row

  /// Counts a reset at `now`. Returns true if there have been kTooMany resets in a row.
  bool add(SimTime now) {
    in_row_ = in_row_ > 0 && now - last_ < kRow ? in_row_ + 1 : 1;
    last_ = now;
    ++count_;
    return in_row_ >= kTooMany;
  }
  /// Returns the number of all resets.
  int count() const { return count_; }
  /// Ends the row, because the power was off.
  void end_row() { in_row_ = 0; }

  /// Returns the reason for the crash report.
  static std::string reason() {
    return fmt::format(
        "the watchdog has reset the chip {} times, each time within {} s of the previous reset", kTooMany,
        kRow / kSecond);
  }

 private:
  int in_row_ = 0, count_ = 0;
  SimTime last_ = 0;
};

}  // namespace robosim::exec
