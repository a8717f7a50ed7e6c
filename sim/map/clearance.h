// Finds the narrowest clearance between a map's paths and its walls.
#pragma once

#include <optional>

#include "sim/map/map.h"

namespace robosim::map {

/// The place where a path comes nearest to a wall.
struct Narrowest {
  int path = 0;              ///< index in Course::paths
  double clearance_m = 0.0;  ///< from the path's centre line to the wall; 0 = the path runs into the wall
  CellAt cell;               ///< the cell in which the path is nearest to the wall
  bool is_edge = false;      ///< the wall is the map's edge
};

/// Returns the narrowest place along all paths of a map, sampled every 5 mm. Returns nullopt if no wall is
/// within `within` m of a path.
std::optional<Narrowest> narrowest(const Map& map, double within);

}  // namespace robosim::map
