// A rectangle or a disc on the floor: the shape of [[area]], [[hill]], [[surface]] and [[joint]] in a map.
#pragma once

#include <cmath>

#include "sim/base/config.h"
#include "sim/base/error.h"
#include "sim/base/vec.h"
#include "sim/map/sampled_parameters.h"

namespace robosim::map {

struct Course;
struct Map;

struct Shape {
  Pose middle;               ///< in m; its heading is along a rectangle's length
  double half_length = 0.0;  ///< half the length of a rectangle in m
  double half_width = 0.0;   ///< half the width of a rectangle in m
  double radius = 0.0;       ///< radius of a disc in m; 0 = a rectangle
  Place place;               ///< place of the table in the map's file
  Vec2 least, most;          ///< in m: corners of the region that contains `middle` for every seed

  /// Returns the distance in m from the centre to the farthest point.
  double reach() const {
    return radius > 0.0 ? radius : std::sqrt(half_length * half_length + half_width * half_width);
  }
  bool contains(Vec2 p) const {
    const Vec2 own = middle.to_body(p);
    if (radius > 0.0) return dot(own, own) <= radius * radius;
    return std::fabs(own.x) <= half_length && std::fabs(own.y) <= half_width;
  }
};

/// Reads a shape from a table. The keys of its place are either `at`, or `along`, `path`, `away` and `side`.
/// The keys of its size are either `size` and `angle`, or `radius`. Messages contain `name`, as in "[[NAME]]"
/// and "a NAME". `course` must already contain the map's paths. `length`, if not null, receives a rectangle's
/// length and its spread. Throws InputError.
Shape read_shape(TableReader& table, const Course& course, const char* name, const SampledParameters& figures,
                 Parameter* length = nullptr);

/// Checks that the centres of a map's areas, hills, surfaces and joints are on its floor for every seed.
/// Throws InputError.
void check_shapes(const Map& map);

/// Returns a shape in the format that read_shape() reads: `at`, then either `radius`, or `size` and `angle`.
std::string shape_text(const Shape& shape);

}  // namespace robosim::map
