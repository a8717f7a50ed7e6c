// Declares the base class of all detectors. Detectors observe a run without changing it, and report behaviour
// that would fail on a real robot (docs/howto/sanitizers.md). The detectors are in sim/detect.
#pragma once

#include <vector>

#include "hal/board/board.h"
#include "sim/result/run_result.h"

namespace robosim::exec {

class Detector {
 public:
  virtual ~Detector() = default;
  /// Returns the findings of the run, which has lasted until `now`.
  virtual std::vector<result::Detected> found(SimTime now) const = 0;
};

}  // namespace robosim::exec
