// Directions from angles with the same bits on every machine, which libm's sine and cosine do not have.
#pragma once

#include "sim/base/vec.h"

namespace robosim {

/// The unit vector at an angle, rad, counter-clockwise from east; exact at quarter turns, else within 2e-16
/// of the true one for angles up to a few turns.
Vec2 unit_vector(double angle);

/// A vector turned by the angle whose direction is `by`.
constexpr Vec2 turned(Vec2 v, Vec2 by) { return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x}; }

/// The angle of a vector, rad, -pi to pi, counter-clockwise from east: the inverse of unit_vector, within
/// 1e-12.
double angle_of(Vec2 v);

}  // namespace robosim
