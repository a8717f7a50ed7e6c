// Computes a robot's pose or tilt during a manual move.
#pragma once

#include "hal/board/sim_time.h"
#include "sim/world/body.h"

namespace robosim::scenario {

/// A motion at constant speed over the floor: to the left, equally far to the right, and back to the start.
struct Sweep {
  Pose base;
  SimTime began, period;
  double reach;  ///< m, distance to each side

  Pose at(SimTime t) const;
};

/// Lifts a robot and tilts it at constant speed. The tilt takes the time `way`. From `end` - `way` to
/// `end`, the robot is levelled at the same speed.
struct Tilt {
  SimTime began, way, end;
  double angle;  ///< rad
  Vec2 side;     ///< the side that goes down, in the robot's frame; a unit vector

  world::Lean at(SimTime t) const;
};

}  // namespace robosim::scenario
