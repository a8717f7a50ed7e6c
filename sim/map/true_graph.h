// The true graph of a map's line: the graph that an explorer must find from a given start. It is derived from
// the cells. The code is independent of the explorer in firmware/src/nav, so that each can check the other.
//
// Nodes are stations (dead ends) and junctions (three or four arms). Lines connect nodes; their bends are
// irrelevant. Stations and junctions are numbered from 1 in the order in which a right-hand walk from the
// start first meets them (network.h). At each junction the walk takes the rightmost way not yet walked. It
// turns around at a dead end, before an obstacle and at a known junction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/map/map.h"

namespace robosim::map {

/// A line as seen from one of its ends.
struct Arm {
  enum class Behind : std::uint8_t { nothing, station, junction, blocked };

  Direction out = Direction::east;  ///< direction in which the line leaves the node
  Behind behind = Behind::nothing;  ///< kind of the line's other end
  int id = 0;                       ///< number of the station or junction at the other end
  int slot = 0;                     ///< slot of this line at the junction at the other end
  int length = 0;                   ///< number of moves to the other node, or to the cell before the obstacle
  CellAt obstacle = {};             ///< cell of the obstacle, if behind is `blocked`
  bool operator==(const Arm&) const = default;
};

struct GraphStation {
  CellAt cell;
  std::string name;  ///< from the map; "" = none
  Arm arm;           ///< arm.behind is `nothing` if the station is a single cell
  bool operator==(const GraphStation&) const = default;
};

struct GraphJunction {
  CellAt cell;
  /// The arms by slot. Slot 0 is the arm by which the walk first arrives. The other slots follow
  /// counter-clockwise: right, straight, left. If the walk starts on the junction, slot 0 is the arm that the
  /// walk takes last: the last existing arm in the order right, straight, left, back.
  std::vector<Arm> arms;
  bool operator==(const GraphJunction&) const = default;
};

struct TrueGraph {
  std::vector<GraphStation> stations;    ///< by number, from 1: stations[0] is number 1
  std::vector<GraphJunction> junctions;  ///< by number, from 1
  std::vector<CellAt> unreachable;       ///< dead ends that are not among the stations, in row order
  bool operator==(const TrueGraph&) const = default;
};

/// Builds the graph. Takes time proportional to the size of the map, and memory proportional to the size of
/// the graph. A line without any node (a ring, or a piece between two obstacles) gives an empty graph.
TrueGraph true_graph(const Map& map, const Start& start);

/// Returns the number of lines, including blocked lines; a line blocked from both ends counts twice.
std::size_t line_count(const TrueGraph& graph);
/// Returns the number of independent cycles: the number of lines to remove to get a tree. Blocked lines do
/// not close cycles.
std::size_t cycle_count(const TrueGraph& graph);

/// Returns the number of moves on a shortest path from station number `station` to each station; -1 =
/// unreachable. result[0] is for station 1. Uses Dijkstra's algorithm.
std::vector<int> distances_from(const TrueGraph& graph, int station);

/// Compares graphs by cells and directions, ignoring numbering and order of slots. Returns "" if they are
/// equal, else one sentence about the first difference.
std::string difference(const TrueGraph& expected, const TrueGraph& found);

}  // namespace robosim::map
