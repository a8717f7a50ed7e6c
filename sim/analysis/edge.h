// Robots on the edge: whether what a target does otherwise than itself, with its clock a little off, is what
// two targets do otherwise. docs/comparing.md says why that tells chance from a fault.
#pragma once

#include "sim/analysis/compare.h"

namespace robosim::analysis {

enum class Alike {
  no,
  elsewhere,  ///< at another time between the same two ways, at a place of the same sort
  there,      ///< at about that time (2 s) of the same kind; or if it is how they end, with one of the same
              ///< verdicts
};

/// `own`: a target's difference from itself; `found`: that of two targets.
Alike alike(const Difference& own, const Difference& found);

/// It is where the robot is, and when: not what it says, and it has no cause that has a name.
bool is_of_driving(const Difference& difference);

}  // namespace robosim::analysis
