// Represents a path by points, with straights between them and rounded bends. This is an implementation
// detail of the readers.
#pragma once

#include <vector>

#include "sim/map/path.h"

namespace robosim::course {

struct Corner {
  Vec2 at;
  double rounding = 0.0;    ///< radius of the bend in m, reduced if the straights are too short; 0 = sharp
  bool gap_behind = false;  ///< unpainted between this point and the next point
};

using Polyline = std::vector<Corner>;

/// Reverses the direction of a line.
void reverse(Polyline& line);

/// Converts at least two different points to a path, in metres. Lengths and radii are rounded to micrometres.
map::Path path_of(const Polyline& line);

/// Divides the path into the sections on each square tile. Returns the middle of each section, in m along the
/// path. Skips sections shorter than 10 mm.
std::vector<double> tile_middles(const map::Path& path, double tile);

}  // namespace robosim::course
