// Converts between cycles of the chip and times.
#pragma once

#include "hal/board/cycle_time.h"
#include "sim/mcu/avr/cycle.h"

namespace robosim::exec::avr {

using robosim::avr::Cycle;

/// All times are measured by the chip's own clock, which may drift from the simulation's clock.
class ClockMap {
 public:
  /// Maps cycle 0 to `began`, the time of the power-on.
  ClockMap(std::int64_t clock_hz, SimTime began) : clock_hz_(clock_hz), cycles_(clock_hz), began_(began) {}

  SimTime time_of(Cycle cycle) const {
    return began_ + cycles_.of(static_cast<SimTime>(cycle) - static_cast<SimTime>(first_));
  }
  /// Returns the first cycle at or after `t`.
  Cycle cycle_at(SimTime t) const {
    return t <= began_ ? first_ : first_ + static_cast<Cycle>(cycles_.first_at(t - began_));
  }
  SimTime length_of(Cycle cycles) const { return cycles_.of(static_cast<SimTime>(cycles)); }
  /// Sets the processor's clock to the oscillator's clock divided by `divisor`, from cycle `at` on.
  void divide(int divisor, Cycle at) {
    began_ = time_of(at);
    first_ = at;
    cycles_ = CycleTime(clock_hz_ / divisor);
    ++divisions_;
  }
  /// Returns the number of changes of the divisor.
  int divisions() const { return divisions_; }

 private:
  std::int64_t clock_hz_;
  CycleTime cycles_;
  SimTime began_;
  Cycle first_ = 0;
  int divisions_ = 0;
};

}  // namespace robosim::exec::avr
