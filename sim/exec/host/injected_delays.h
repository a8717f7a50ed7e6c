// Stores the times at which a sketch is delayed as if its code took longer. The array has the format that the
// sketch's image reads.
#pragma once

#include <vector>

#include "hal/host/image.h"
#include "sim/result/lateness.h"

namespace robosim::exec {

class InjectedDelays {
 public:
  /// Sets the times, in ascending order.
  void set(const std::vector<result::Lateness>& late) {
    times_.clear();
    for (const result::Lateness& one : late) times_.push_back({one.from_ns, one.by_ns});
    times_.emplace_back();
  }
  /// Gives the sketch, which starts at `t`, the times that are not before `t`. set() must not be called while
  /// the sketch runs.
  void begin(host::FirmwareState& state, SimTime t) const {
    state.lateness = times_.data();
    while (state.lateness->from < t) ++state.lateness;
    state.late_from = state.lateness->from;
  }

 private:
  std::vector<host::Lateness> times_{{}};  // the last element marks the end and is never reached
};

}  // namespace robosim::exec
