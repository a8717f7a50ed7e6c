// Manual moves of a robot.
#pragma once

#include "hal/board/sim_time.h"
#include "sim/world/body.h"

namespace robosim::scenario {

/// A motion to and fro over the floor at constant speed: to the left, to the right as far, and back.
struct Sweep {
  Pose base;
  SimTime began, period;
  double reach;  ///< m

  Pose at(SimTime t) const;
};

/// Lifted and tilted, at constant speed in the time `way`, and back equally fast, so that it is level again
/// at `end`.
struct Tilt {
  SimTime began, way, end;
  double angle;  ///< rad
  Vec2 side;     ///< of the robot's frame, the side that goes down; a unit vector

  world::Lean at(SimTime t) const;
};

}  // namespace robosim::scenario
