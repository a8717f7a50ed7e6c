// The room that a robot has next to the paths of a map.
#pragma once

#include <optional>

#include "sim/grid/map.h"

namespace robosim::grid {

/// The place where a path comes nearest to a wall.
struct Narrowest {
  int path = 0;              ///< its number in the map, from 0
  double clearance_m = 0.0;  ///< from the path's middle to the wall; 0 = it runs into one
  CellAt cell;               ///< the cell in which the path is nearest to the wall
  bool is_edge = false;      ///< the wall is the map's edge
};

/// Returns the narrowest place of all paths of a map, sampled every 5 mm; nothing if there is no path, or no
/// wall within `within`, m.
std::optional<Narrowest> narrowest(const Map& map, double within);

}  // namespace robosim::grid
