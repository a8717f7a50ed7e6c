// The line network of a map: line cells are nodes, and 4-adjacent ones are connected.
#pragma once

#include <string>
#include <vector>

#include "sim/grid/map.h"

namespace robosim::grid {

struct Station {
  int id = 0;        ///< from 1, in the order of the right-hand walk from the start, as v1 numbers them
  std::string name;  ///< the map's, else the id as text
  CellAt cell;
};

/// The part of the network that is reachable along the line from one start.
struct Network {
  std::vector<Station> stations;  ///< dead ends in numbering order, then named places that are not dead ends
  std::vector<CellAt> junctions;  ///< nodes of degree 3 or 4, in the order of the walk
  std::vector<CellAt> unreachable;  ///< dead ends that no line (free of obstacles) joins to the start
  /// If the reachable network is one closed loop (every node of degree 2, or of degree 4 and crossed
  /// straight): its nodes in the order of travel from the start. Otherwise empty.
  std::vector<CellAt> loop;
  /// If the start is on a closed path: points along it, close together, in the order of travel, m.
  std::vector<Vec2> lap;

  bool has_laps() const { return !loop.empty() || !lap.empty(); }
};

Network trace_network(const Map& map, const Start& start);

/// Returns the network without `unreachable`, which takes a scan of the whole map: for many starts on one
/// map.
Network trace_reachable(const Map& map, const Start& start);

}  // namespace robosim::grid
