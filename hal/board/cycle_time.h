// Converts a number of clock cycles to whole nanoseconds, rounded down. Pass the number of cycles since the
// start, not increments, so that no rounding error accumulates.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {

class CycleTime {
 public:
  constexpr explicit CycleTime(int64_t clock_hz)
      : nanos_(kSecond / common(kSecond, clock_hz)), cycles_(clock_hz / common(kSecond, clock_hz)) {}

  /// Returns the time from the start of cycle 0 to the start of cycle `count`.
  constexpr SimTime of(int64_t count) const { return count * nanos_ / cycles_; }
  /// Returns the time from the start of cycle 0 to the start of cycle `count`, rounded up.
  constexpr SimTime at_least(int64_t count) const { return (count * nanos_ + cycles_ - 1) / cycles_; }
  /// Returns the number of whole periods of `length` cycles in `time`.
  constexpr int64_t whole(SimTime time, int64_t length = 1) const {
    return time * cycles_ / (nanos_ * length);
  }
  /// Returns the first cycle that begins at or after `time`.
  constexpr int64_t first_at(SimTime time) const { return (time * cycles_ + nanos_ - 1) / nanos_; }

 private:
  static constexpr int64_t common(int64_t a, int64_t b) { return b == 0 ? a : common(b, a % b); }

  // A cycle takes nanos_ / cycles_ ns. The fraction is in lowest terms: 125 / 2 at 16 MHz.
  int64_t nanos_;
  int64_t cycles_;
};

}  // namespace robosim
