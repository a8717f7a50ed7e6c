// The true graph of a map's line, which an explorer that starts at a given place must find. It is derived
// from the cells. It shares no code with the navigator in firmware/src/nav, so that the two can check each
// other.
//
// Nodes are stations (dead ends) and junctions (three or four arms). Line runs between them; its bends are
// irrelevant. Stations and junctions are numbered from 1 in the order in which a right-hand walk from the
// start first meets them (network.h). At each junction the walk takes the rightmost way not yet walked. It
// turns round at a dead end, before an obstacle and at a known junction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/grid/map.h"

namespace robosim::grid {

/// A line as seen from one of its ends.
struct Arm {
  enum class Behind : std::uint8_t { nothing, station, junction, blocked };

  Direction out = Direction::east;  ///< the direction in which it leaves the node
  Behind behind = Behind::nothing;  ///< what is at its other end
  int id = 0;                       ///< of the station or junction there
  int slot = 0;                     ///< of this line at that junction
  int length = 0;        ///< moves from node to node, or until the robot stands before the obstacle
  CellAt obstacle = {};  ///< where it is, if behind is `blocked`
  bool operator==(const Arm&) const = default;
};

struct GraphStation {
  CellAt cell;
  std::string name;  ///< from the map; "" = none
  Arm arm;           ///< behind it is nothing if the station is a single cell
  bool operator==(const GraphStation&) const = default;
};

struct GraphJunction {
  CellAt cell;
  /// Its slots: 0 is the arm by which the walk first came. The others follow counter-clockwise: right,
  /// straight, left. At a start on a junction, 0 is the arm that the walk takes last (of right, straight,
  /// left, back).
  std::vector<Arm> arms;
  bool operator==(const GraphJunction&) const = default;
};

struct TrueGraph {
  std::vector<GraphStation> stations;    ///< by number, from 1: stations[0] is number 1
  std::vector<GraphJunction> junctions;  ///< by number, from 1
  std::vector<CellAt> unreachable;       ///< dead ends that are not among the stations, in row order
  bool operator==(const TrueGraph&) const = default;
};

/// Builds the graph. Time is proportional to the map, memory to the graph. A line without any node (a ring,
/// or a piece between two obstacles) gives an empty graph.
TrueGraph true_graph(const Map& map, const Start& start);

/// Returns the number of lines, including blocked ones; a line blocked from both ends counts twice.
std::size_t line_count(const TrueGraph& graph);
/// Returns the number of independent cycles: the lines to remove for a tree. Blocked lines do not close
/// cycles.
std::size_t cycle_count(const TrueGraph& graph);

/// Returns the moves of a shortest path from a station (its number) to each station: result[0] is for number
/// 1. -1 if unreachable. Dijkstra's algorithm.
std::vector<int> distances_from(const TrueGraph& graph, int station);

/// Compares graphs by cells and directions, ignoring numbering and order of slots. Returns "" if they are
/// equal, else one sentence about the first difference.
std::string difference(const TrueGraph& expected, const TrueGraph& found);

}  // namespace robosim::grid
