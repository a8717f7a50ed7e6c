// Resets by a watchdog. Now and then one is what it is for; firmware that gets nowhere between them has
// crashed.
#pragma once

#include <fmt/format.h>

#include <string>

#include "hal/board/sim_time.h"

namespace robosim::exec {

class Bites {
 public:
  static constexpr int kTooMany = 3;
  static constexpr SimTime kRow = 10 * kSecond;  ///< a row goes on if the next one comes within

  /// One more; true if they are too many.
  bool add(SimTime now) {
    in_row_ = in_row_ > 0 && now - last_ < kRow ? in_row_ + 1 : 1;
    last_ = now;
    return in_row_ >= kTooMany;
  }

  /// Why it is a crash.
  static std::string reason() {
    return fmt::format("the watchdog has reset the chip {} times, each time within {} s of the one before",
                       kTooMany, kRow / kSecond);
  }

 private:
  int in_row_ = 0;
  SimTime last_ = 0;
};

}  // namespace robosim::exec
