// The parts of a map other than cells: paths, marks next to them, and painted areas.
#pragma once

#include <optional>
#include <vector>

#include "sim/grid/colour.h"
#include "sim/grid/paint.h"
#include "sim/grid/path.h"
#include "sim/grid/relief.h"
#include "sim/grid/shape.h"

namespace robosim::grid {

/// A painted bar of the line's colour: Robotrace's corner, start and goal markers.
struct Mark {
  int path = 0;              ///< index of the path that the mark stands next to
  double along = 0.0;        ///< m from that path's beginning
  double away = 0.0;         ///< m from the path to its middle, positive to the left
  Pose middle;               ///< m; the heading is that of its long side, across the path
  double half_length = 0.0;  ///< m
  double half_width = 0.0;   ///< m
  int paint = 0;             ///< its number in paints_of; the width there is not the mark's
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
  bool over_lines = false;  ///< painted over lines and marks; else they are painted over it
  double gloss = 0.0;       ///< what it mirrors: Paint::gloss
};

/// Start and goal line of a path, m along it. A race goes from the start to the goal. The path is closed if
/// there is no braking distance.
struct RaceLines {
  int path = 0;  ///< an index
  double start = 0.0;
  double goal = 0.0;
  double braking = 0.0;  ///< m behind the goal line, of a drag race; 0 = none
  double signal = 0.0;   ///< s, when a drag race is started; 0 = when the robot leaves
};

/// A course of tiles along the whole first path: RoboCupJunior's Rescue Line.
struct RescueCourse {
  double tile = 0.3;                ///< m, side
  Vec2 origin;                      ///< m, a corner of a tile
  bool to_zone = false;             ///< it ends at the evacuation zone, not at the end tile
  std::vector<double> checkpoints;  ///< m along the path, ascending: the tiles there
  bool is_entry = false;            ///< by the rules of Rescue Line Entry
};

struct Course {
  std::vector<Path> paths;
  std::vector<Paint> paints;  ///< of pieces and marks that are not as the map's lines are
  std::optional<RaceLines> race;
  std::optional<RescueCourse> rescue;
  std::vector<Mark> marks;
  std::vector<Area> areas;  ///< in the order in which they are painted
  std::vector<Hill> hills;
  std::vector<Surface> surfaces;  ///< if some of them overlap, the last one counts
  std::vector<Joint> joints;
  /// Returns whether there are neither paths nor marks.
  bool empty() const { return paths.empty() && marks.empty(); }
};

/// Returns what sensors see: the course's areas, and above lines and everything else the dark of its joints.
std::vector<Area> visible_areas(const Course& course);

}  // namespace robosim::grid
