// The times at which a sketch is delayed, as if its code took longer, in the form that its image reads.
#pragma once

#include <vector>

#include "hal/host/image.h"
#include "sim/wire/lateness.h"

namespace robosim::exec {

class InjectedDelays {
 public:
  /// Sets the times, in rising order.
  void set(const std::vector<wire::Lateness>& late) {
    times_.clear();
    for (const wire::Lateness& one : late) times_.push_back({one.from_ns, one.by_ns});
    times_.emplace_back();
  }
  /// Passes the times from `t` on to the sketch that begins there. They must not change while it runs.
  void begin(host::FirmwareState& state, SimTime t) const {
    state.lateness = times_.data();
    while (state.lateness->from < t) ++state.lateness;
    state.late_from = state.lateness->from;
  }

 private:
  std::vector<host::Lateness> times_{{}};  // the last one is never reached
};

}  // namespace robosim::exec
