// Points with straights between them and rounded bends, as a path. An implementation detail of the readers.
#pragma once

#include <vector>

#include "sim/grid/path.h"

namespace robosim::course {

struct Corner {
  Vec2 at;
  double rounding = 0.0;    ///< m: the radius of the bend, smaller where its legs are too short; 0 = sharp
  bool gap_behind = false;  ///< nothing is painted from here to the next point
};

using Polyline = std::vector<Corner>;

/// The same the other way.
void reverse(Polyline& line);

/// Of at least two points that are not the same. In metres; lengths and radii are rounded to micrometres.
grid::Path path_of(const Polyline& line);

/// The middles of its ways over square tiles, m along it; of those that are 10 mm or longer.
std::vector<double> tile_middles(const grid::Path& path, double tile);

}  // namespace robosim::course
