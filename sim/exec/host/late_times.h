// When a sketch is late, as if its code took longer, as its image has it.
#pragma once

#include <vector>

#include "hal/host/image.h"
#include "sim/wire/lateness.h"

namespace robosim::exec {

class LateTimes {
 public:
  /// In the order of their times.
  void set(const std::vector<wire::Lateness>& late) {
    times_.clear();
    for (const wire::Lateness& one : late) times_.push_back({one.from_ns, one.by_ns});
    times_.emplace_back();
  }
  /// Those from `t` on are for the sketch that begins there. They must stay as they are while it runs.
  void begin(host::FirmwareState& state, SimTime t) const {
    state.lateness = times_.data();
    while (state.lateness->from < t) ++state.lateness;
    state.late_from = state.lateness->from;
  }

 private:
  std::vector<host::Lateness> times_{{}};  // the last one never comes
};

}  // namespace robosim::exec
