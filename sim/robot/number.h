// Numbers that differ from one robot to the next.
#pragma once

#include "sim/base/noise.h"

namespace robosim::robot {

/// A figure of a robot file: `"625 rpm"`, or `{ value = "625 rpm", spread = "5 %" }`.
struct Number {
  double value = 0.0;   ///< SI
  double spread = 0.0;  ///< SI; every robot's own value lies in value ± spread, uniformly

  /// The value for the robot that this noise stream belongs to.
  double drawn(const NoiseStream& stream) const {
    return spread == 0.0 ? value : value + spread * (2.0 * stream.uniform(0) - 1.0);
  }
};

}  // namespace robosim::robot
