// Computes the distance to a disc, for sensors that look along the floor.
#pragma once

#include "sim/base/vec.h"

namespace robosim::world {

/// Returns the distance along a ray to the disc, m; infinity if the ray misses, 0 from inside. `direction` is
/// a unit vector.
double range_to_disc(Vec2 from, Vec2 direction, Vec2 centre, double radius);
/// Returns the distance to the disc's nearest point in a beam, like Walls::range_in_beam().
double range_to_disc(Vec2 from, Vec2 direction, Vec2 half_beam, Vec2 centre, double radius);

}  // namespace robosim::world
