// Detects the manual moves that a script makes with the robot. The robot's path then contains a part that the
// robot did not drive.
#pragma once

#include <utility>

#include "sim/wire/stream.h"

namespace robosim::wire {

/// Processes the notes and samples of a run, in their order.
class Hand {
 public:
  void add(const Note& note) {
    const ScriptActed* acted = note.is<ScriptActed>();
    if (!acted ||
        (acted->verb != "place" && acted->verb != "lift" && acted->verb != "lower" && acted->verb != "sweep"))
      return;
    moved_ = true;
    sweeps_ = acted->verb == "sweep";
  }
  /// Returns whether the script has moved the robot since the previous sample. Call once per sample.
  bool has_moved() { return std::exchange(moved_, sweeps_); }

 private:
  bool moved_ = false, sweeps_ = false;
};

}  // namespace robosim::wire
