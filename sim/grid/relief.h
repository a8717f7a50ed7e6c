// [[hill]], [[surface]] and [[joint]] of a map: the floor's height, its surfaces, and the gaps in it. Without
// them, and without surfaces in its [legend] (legend.h), the floor is a uniform plane.
//
// The map is the unrolled floor, like a course's tiles before they are put on a ramp. Its lengths run along
// the slope, so that dh/ds of a height h is the sine of its angle.
#pragma once

#include <string>
#include <vector>

#include "sim/base/config.h"
#include "sim/grid/sampled_parameters.h"
#include "sim/grid/shape.h"

namespace robosim::grid {

struct Course;

/// A raised rectangle. Its heights run along its length, and are the same across it. Ends and sides that are
/// higher than the floor next to them are steps.
struct Hill : Shape {
  std::vector<double> heights;  ///< m, at even distances from its beginning to its end, straight in between
  double pivot = 0.0;           ///< m, height of a seesaw's axis; 0 = no seesaw. Its beginning is down first
  double plank_kg = 0.0;        ///< of a seesaw

  /// Returns the height at a point of it, m; 0 for a seesaw, which has no fixed height.
  double height_at(Vec2 p) const;
};

/// A kind of surface, relative to the one that the robot file's parameters are for.
struct SurfaceKind {
  const char* name;
  double grip;     ///< multiplies the robot's grip
  double rolling;  ///< is added to the robot's rolling resistance: force / weight
};

// Rubber: wet asphalt has 0.55 to 0.65 of dry asphalt's friction, 0.4 to 0.5 against 0.7 to 0.8 (Engineering
// ToolBox, friction coefficients of tyres). The grip on dust is an estimate. So is the rolling resistance of
// small wheels on low pile: 0.07, against 0.02 on a hard floor.
constexpr SurfaceKind kSurfaces[] = {{"wet", 0.6, 0.0}, {"dusty", 0.5, 0.0}, {"carpet", 1.0, 0.05}};

struct SurfaceFigures {
  double grip = 1.0;  ///< as SurfaceKind has them
  double rolling = 0.0;
};
struct Surface : Shape, SurfaceFigures {};

/// Returns the names of all kinds of surface, for messages: "wet, dusty or carpet".
std::string surface_names();
/// Reads kind, or grip and rolling, of a table that is a surface. Throws InputError.
SurfaceFigures read_surface_figures(TableReader& table, const SampledParameters& figures);

/// A gap between two boards. Its length, along its heading, is the gap's width.
struct Joint : Shape {
  static constexpr double kWidest = 0.006;  ///< m: a wheel's tread is wider
};

/// Read all [[hill]], [[surface]] and [[joint]] tables; `course` has the paths that they may lie along. Throw
/// InputError.
void read_hills(const ConfigValue& value, Course& course, Draw draw = {});
void read_surfaces(const ConfigValue& value, Course& course, Draw draw = {});
void read_joints(const ConfigValue& value, Course& course, Draw draw = {});

/// Returns the course's hills, surfaces and joints as in a map's file. An implementation detail of write_map.
std::string relief_text(const Course& course);

}  // namespace robosim::grid
