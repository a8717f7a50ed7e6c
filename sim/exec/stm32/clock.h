// Converts between processor cycles and simulated time. The cycle duration changes when firmware switches the
// clock.
#pragma once

#include <algorithm>
#include <cstdint>

#include "hal/board/sim_time.h"

namespace robosim::exec::stm32 {

using Cycle = std::uint64_t;
constexpr Cycle kNoCycle = ~Cycle{0};

class Clock {
 public:
  explicit Clock(SimTime began) : base_time_(began) {}

  Cycle now = 0;           ///< cycles since power-on
  SimTime limit = kNever;  ///< end of the tick; the last instruction of the tick may end later

  std::uint32_t hz() const { return static_cast<std::uint32_t>(hz_); }
  /// Sets the cycle duration to 1/hz from `now` on. Times are rounded down to a nanosecond. Only calls of
  /// set_hz() accumulate rounding errors, less than 1 ns each.
  void set_hz(std::uint32_t hz) {
    if (static_cast<SimTime>(hz) == hz_) return;
    base_time_ = time_of(now);
    base_cycle_ = now;
    hz_ = hz;
  }

  SimTime time_of(Cycle cycle) const {
    const auto cycles = static_cast<SimTime>(cycle - base_cycle_);
    return base_time_ + cycles / hz_ * kSecond + cycles % hz_ * kSecond / hz_;
  }
  /// Returns the first cycle at or after `t`.
  Cycle cycle_at(SimTime t) const {
    if (t <= base_time_) return base_cycle_;
    if (t == kNever) return kNoCycle;
    const SimTime d = t - base_time_;
    return base_cycle_ + static_cast<Cycle>(d / kSecond * hz_ + (d % kSecond * hz_ + kSecond - 1) / kSecond);
  }
  SimTime time() const { return std::min(time_of(now), limit); }
  Cycle cycles_in(SimTime duration) const {
    return static_cast<Cycle>((duration * hz_ + kSecond - 1) / kSecond);
  }

 private:
  SimTime base_time_;
  Cycle base_cycle_ = 0;
  SimTime hz_ = 8'000'000;  ///< the internal oscillator, which runs after a reset
};

}  // namespace robosim::exec::stm32
