// How far away a disc is, for what looks along the floor.
#pragma once

#include "sim/base/vec.h"

namespace robosim::world {

/// m along a ray to the disc; infinity if it passes, 0 from inside. `direction` is a unit vector.
double range_to_disc(Vec2 from, Vec2 direction, Vec2 centre, double radius);
/// To the disc's nearest point in a beam, as Walls::range_in_beam() has it.
double range_to_disc(Vec2 from, Vec2 direction, Vec2 half_beam, Vec2 centre, double radius);

}  // namespace robosim::world
