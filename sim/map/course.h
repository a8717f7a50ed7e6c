// Defines the parts of a map other than its cells: paths, marks, painted areas, hills, surfaces, joints, and
// the tables of races and Rescue courses.
#pragma once

#include <optional>
#include <vector>

#include "sim/map/colour.h"
#include "sim/map/paint.h"
#include "sim/map/path.h"
#include "sim/map/relief.h"
#include "sim/map/shape.h"

namespace robosim::map {

/// A painted bar next to a path, such as Robotrace's corner, start and goal markers.
struct Mark {
  int path = 0;              ///< index in Course::paths
  double along = 0.0;        ///< in m: distance along the path from its beginning
  double away = 0.0;         ///< in m: distance from the path to the mark's middle, positive to the left
  Pose middle;               ///< in m; the heading is along the mark's long side, across the path
  double half_length = 0.0;  ///< in m
  double half_width = 0.0;   ///< in m
  int paint = 0;             ///< index in paints_of(); a mark does not use that paint's width
};

/// Returns a mark next to a path; `length_m` is its long side.
inline Mark mark_beside(const std::vector<Path>& paths, int path, double along, double away, double length_m,
                        double width_m) {
  const Pose on = paths[static_cast<std::size_t>(path)].at(along, false);
  return {
      path,           along,         away, {on.position + left_of(on.heading) * away, left_of(on.heading)},
      0.5 * length_m, 0.5 * width_m, 0};
}

/// A painted rectangle or disc.
struct Area : Shape {
  Colour colour;
  bool over_lines = false;  ///< painted over lines and marks, not under them
  double gloss = 0.0;       ///< as Paint::gloss
};

/// Start and goal lines of a race, as distances along a path in m. A race with a braking distance is a drag
/// race. Any other race requires a closed path.
struct RaceLines {
  int path = 0;  ///< index in Course::paths
  double start = 0.0;
  double goal = 0.0;
  double braking = 0.0;  ///< braking distance in m after a drag race's goal line; 0 = not a drag race
  double signal = 0.0;   ///< time of a drag race's starting signal in s; 0 = no signal
};

/// A course of tiles along the whole first path: RoboCupJunior's Rescue Line.
struct RescueCourse {
  double tile = 0.3;                ///< side of a tile in m
  Vec2 origin;                      ///< a corner of a tile, in m
  bool to_zone = false;             ///< the path ends at the evacuation zone, not at the end tile
  std::vector<double> checkpoints;  ///< distances along the path in m, ascending; each selects its tile
  bool is_entry = false;            ///< the rules of Rescue Line Entry apply
};

struct Course {
  std::vector<Path> paths;
  std::vector<Paint> paints;  ///< paints of pieces and marks that differ from the map's default
  std::optional<RaceLines> race;
  std::optional<RescueCourse> rescue;
  std::vector<Mark> marks;
  std::vector<Area> areas;  ///< in painting order
  std::vector<Hill> hills;
  std::vector<Surface> surfaces;  ///< if surfaces overlap, the last one applies
  std::vector<Joint> joints;
  /// Returns whether there are neither paths nor marks.
  bool empty() const { return paths.empty() && marks.empty(); }
};

/// Returns the areas that sensors see: the course's areas, and its joints as black areas on top of
/// everything.
std::vector<Area> visible_areas(const Course& course);

}  // namespace robosim::map
