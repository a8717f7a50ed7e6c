// How much room a robot has beside the paths of a map.
#pragma once

#include <optional>

#include "sim/grid/map.h"

namespace robosim::grid {

/// Where a path comes nearest to a wall.
struct Narrowest {
  int path = 0;          ///< its number in the map, from 0
  double room_m = 0.0;   ///< from the path's middle to the wall; 0 = it runs into one
  CellAt cell;           ///< in which the path is there
  bool is_edge = false;  ///< the wall is the map's edge
};

/// Of all paths of a map, looked at every 5 mm; nothing where it has none. Walls farther off than `within`,
/// m, are not looked for: then there is nothing either.
std::optional<Narrowest> narrowest(const Map& map, double within);

}  // namespace robosim::grid
