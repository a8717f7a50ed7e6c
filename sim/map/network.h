// The line network of a map. Line cells are nodes; 4-adjacent line cells are connected.
#pragma once

#include <string>
#include <vector>

#include "sim/map/map.h"

namespace robosim::map {

struct Station {
  int id = 0;        ///< from 1, in the order of the right-hand walk from the start (as in Robosim v1)
  std::string name;  ///< from the map, else the id as text
  CellAt cell;
};

/// The part of the network that is reachable along the line from one start.
struct Network {
  std::vector<Station> stations;    ///< dead ends in the order of their ids, then other named places
  std::vector<CellAt> junctions;    ///< nodes of degree 3 or 4, in the order of the walk
  std::vector<CellAt> unreachable;  ///< dead ends and named places without an obstacle-free line to the start
  /// The nodes in the order of travel from the start, if the reachable network is one closed loop; else
  /// empty. Each node of a loop has degree 2, or has degree 4 and is crossed straight.
  std::vector<CellAt> loop;
  /// Closely spaced points along the path in the order of travel, in metres. Empty if the start is not on a
  /// closed path.
  std::vector<Vec2> lap;

  bool has_laps() const { return !loop.empty() || !lap.empty(); }
};

Network trace_network(const Map& map, const Start& start);

/// Returns the network, but leaves `unreachable` empty, because finding these cells requires a scan of the
/// whole map. Use this for many starts on one map.
Network trace_reachable(const Map& map, const Start& start);

}  // namespace robosim::map
