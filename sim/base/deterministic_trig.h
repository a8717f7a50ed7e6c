// Converts angles to directions with the same bits on every machine, unlike libm's sine and cosine.
#pragma once

#include "sim/base/vec.h"

namespace robosim {

/// Returns the unit vector at an angle, rad, counter-clockwise from east. Exact at quarter turns, otherwise
/// within 2e-16 for angles up to a few turns.
Vec2 unit_vector(double angle);

/// Returns `v` rotated by the angle whose direction is `by`.
constexpr Vec2 turned(Vec2 v, Vec2 by) { return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x}; }

/// Returns the angle of a vector, rad, -pi to pi, counter-clockwise from east: the inverse of unit_vector,
/// within 1e-12.
double angle_of(Vec2 v);

}  // namespace robosim
