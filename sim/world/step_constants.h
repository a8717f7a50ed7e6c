// Defines constants and functions that the parts of a body's step share.
#pragma once

#include "hal/board/sim_time.h"
#include "sim/base/units.h"

namespace robosim::world {

/// The duration of a tick, s.
constexpr double kDt = static_cast<double>(kTick) / static_cast<double>(kSecond);

// No motor reaches these limits. They keep a step finite for any parameters.
constexpr double kMaxSpeed = 100.0;  ///< m/s
constexpr double kMaxTurn = 500.0;   ///< rad/s

/// Share of the grip in each direction, lengthwise and sideways, while a body skids: 1 / sqrt(2).
constexpr double kSkidShare = 0.70710678118654752;

/// Returns x limited to ±bound; 0 for NaN.
inline double bounded(double x, double bound) {
  if (x > bound) return bound;
  if (x < -bound) return -bound;
  return x == x ? x : 0.0;
}

}  // namespace robosim::world
