// Manual moves of a robot.
#pragma once

#include "hal/board/sim_time.h"
#include "sim/world/body.h"

namespace robosim::scenario {

/// A motion to and fro over the floor at constant speed: to the left, equally far to the right, and back.
struct Sweep {
  Pose base;
  SimTime began, period;
  double reach;  ///< m

  Pose at(SimTime t) const;
};

/// Lifts the robot and tilts it at constant speed during `way`, and levels it equally fast before `end`.
struct Tilt {
  SimTime began, way, end;
  double angle;  ///< rad
  Vec2 side;     ///< the side that goes down, in the robot's frame; a unit vector

  world::Lean at(SimTime t) const;
};

}  // namespace robosim::scenario
