// The true graph of a map's line: what an explorer that starts at a given place must find. It is read off the
// cells and shares no code with the navigator in firmware/src/nav, so that the two can check each other.
//
// Nodes are stations (dead ends) and junctions (three or four arms). Line runs between them; its bends do not
// matter. Stations and junctions are numbered from 1 as a right-hand walk from the start meets them first
// (network.h): at each junction it takes the rightmost way not yet walked, at a dead end, before an obstacle
// and at a junction that it knows it turns round.
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
  /// Its slots: 0 is the arm by which the walk first came, then as they follow to the right hand of somebody
  /// who comes in by it. At a start on a junction, 0 is the arm the walk takes last (of right, straight,
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

/// Takes time in proportion to the map, memory in proportion to the graph. A line without any node (a ring,
/// or a piece between two obstacles) gives an empty graph.
TrueGraph true_graph(const Map& map, const Start& start);

/// How many lines a graph has, blocked ones included; one blocked from both ends counts twice.
std::size_t line_count(const TrueGraph& graph);
/// How many lines are to be taken out for a tree: independent cycles. Blocked lines close none.
std::size_t cycle_count(const TrueGraph& graph);

/// The moves of a shortest way from a station (its number) to each station, by number from 1: result[0] is
/// for number 1. -1 where there is none. Dijkstra's algorithm.
std::vector<int> distances_from(const TrueGraph& graph, int station);

/// Compares graphs up to numbering and order of slots: by cells and directions. "" if they are the same, else
/// one sentence about the first difference.
std::string difference(const TrueGraph& expected, const TrueGraph& found);

}  // namespace robosim::grid
