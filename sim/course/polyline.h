// A path of points with straights between them and rounded bends. An implementation detail of the readers.
#pragma once

#include <vector>

#include "sim/grid/path.h"

namespace robosim::course {

struct Corner {
  Vec2 at;
  double rounding = 0.0;    ///< m: the radius of the bend, smaller if its legs are too short; 0 = sharp
  bool gap_behind = false;  ///< unpainted from here to the next point
};

using Polyline = std::vector<Corner>;

/// Reverses the direction.
void reverse(Polyline& line);

/// Converts at least two different points. In metres; lengths and radii are rounded to micrometres.
grid::Path path_of(const Polyline& line);

/// Returns the middles of its sections over square tiles, in m along it, for sections of at least 10 mm.
std::vector<double> tile_middles(const grid::Path& path, double tile);

}  // namespace robosim::course
