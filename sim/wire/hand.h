// Detects that a script moves the robot by hand. Such a move adds a part to the robot's path that the robot
// did not drive.
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
  /// Returns whether the robot was moved since the previous sample. Call once per sample.
  bool has_moved() { return std::exchange(moved_, sweeps_); }

 private:
  bool moved_ = false, sweeps_ = false;
};

}  // namespace robosim::wire
