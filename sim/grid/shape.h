// A rectangle or a disc on the floor, as [[area]], [[hill]], [[surface]] and [[joint]] of a map have it.
#pragma once

#include <cmath>

#include "sim/base/config.h"
#include "sim/base/error.h"
#include "sim/base/vec.h"
#include "sim/grid/sampled_parameters.h"

namespace robosim::grid {

struct Course;
struct Map;

struct Shape {
  Pose middle;               ///< m; the heading is that of a rectangle's length
  double half_length = 0.0;  ///< m, of a rectangle
  double half_width = 0.0;   ///< m, of a rectangle
  double radius = 0.0;       ///< m, of a disc; 0 = a rectangle
  Place place;               ///< where the map's file has it
  Vec2 least, most;          ///< m, corners of where its middle may be, whatever is drawn

  /// Returns the distance from its centre to its farthest point, m.
  double reach() const {
    return radius > 0.0 ? radius : std::sqrt(half_length * half_length + half_width * half_width);
  }
  bool contains(Vec2 p) const {
    const Vec2 own = middle.to_body(p);
    if (radius > 0.0) return dot(own, own) <= radius * radius;
    return std::fabs(own.x) <= half_length && std::fabs(own.y) <= half_width;
  }
};

/// Reads at, or along, path, away and side, and size and angle, or radius, of a table. Messages call the
/// table "[[NAME]]", and its object "a NAME". `course` has the paths read before. `length`, if given, limits
/// a rectangle's length. Throws InputError.
Shape read_shape(TableReader& table, const Course& course, const char* name, const SampledParameters& figures,
                 Parameter* length = nullptr);

/// Checks that the centres of a map's areas, hills, surfaces and joints are on its floor, for any draw.
/// Throws InputError.
void check_shapes(const Map& map);

/// Writes at and size, angle, or radius as read_shape reads them.
std::string shape_text(const Shape& shape);

}  // namespace robosim::grid
