// [[hill]], [[surface]] and [[joint]] of a map: the floor's height, its surfaces, and its gaps. Without these
// tables, and without surfaces in the map's [legend] (legend.h), the floor is a uniform plane.
//
// The map shows the unrolled floor, like a course's tiles before they are put on a ramp. Lengths are measured
// along the slope. For a height h, dh/ds is therefore the sine of the slope angle.
#pragma once

#include <string>
#include <vector>

#include "sim/base/config.h"
#include "sim/map/sampled_parameters.h"
#include "sim/map/shape.h"

namespace robosim::map {

struct Course;

/// A raised rectangle. Its height varies along its length and is constant across its width. Ends and sides
/// that are higher than the floor next to them are steps.
struct Hill : Shape {
  std::vector<double> heights;  ///< in m, at even distances from the beginning to the end, linear in between
  double pivot = 0.0;     ///< height of a seesaw's axis in m (0 = no seesaw); the beginning is down at first
  double plank_kg = 0.0;  ///< mass of a seesaw's plank

  /// Returns the hill's height in m at a point; 0 for a seesaw, which has no fixed height.
  double height_at(Vec2 p) const;
};

/// A kind of surface, relative to the surface that the robot file's parameters assume.
struct SurfaceKind {
  const char* name;
  double grip;     ///< multiplies the robot's grip
  double rolling;  ///< added to the robot's rolling resistance: force / weight
};

// The friction of rubber on wet asphalt is 0.55 to 0.65 of its friction on dry asphalt: 0.4 to 0.5 against
// 0.7 to 0.8 (Engineering ToolBox, friction coefficients of tyres). The grip on dust is an estimate. The
// rolling resistance of small wheels on low pile is also an estimate: 0.07, against 0.02 on a hard floor.
constexpr SurfaceKind kSurfaces[] = {{"wet", 0.6, 0.0}, {"dusty", 0.5, 0.0}, {"carpet", 1.0, 0.05}};

struct SurfaceFigures {
  double grip = 1.0;  ///< as in SurfaceKind
  double rolling = 0.0;
};
struct Surface : Shape, SurfaceFigures {};

/// Returns the names of all kinds of surface, for messages: "wet, dusty or carpet".
std::string surface_names();
/// Reads `kind`, or `grip` and `rolling`, from a surface's table. Throws InputError.
SurfaceFigures read_surface_figures(TableReader& table, const SampledParameters& figures);

/// A gap between two boards. The length of the shape, along its heading, is the width of the gap.
struct Joint : Shape {
  static constexpr double kWidest = 0.006;  ///< in m; a wheel's tread is wider
};

/// Read all [[hill]], [[surface]] and [[joint]] tables. `course` contains the paths to which the tables may
/// refer. Throw InputError.
void read_hills(const ConfigValue& value, Course& course, Draw draw = {});
void read_surfaces(const ConfigValue& value, Course& course, Draw draw = {});
void read_joints(const ConfigValue& value, Course& course, Draw draw = {});

/// Returns the course's hills, surfaces and joints as text for a map file. An implementation detail of
/// write_map.
std::string relief_text(const Course& course);

}  // namespace robosim::map
