// Implements the third algorithm of `robosim classic`: scans a floor into a graph, then uses the graph to
// drive from station to station.
//
// The navigator's explorer (firmware/src/nav/Explorer.h) makes the scan. As in Robosim v1, the robot ends the
// scan at the start, facing the line. If the start is not the end of a line, the robot continues to station 1
// by a shortest path. Without stations, it stays at the start.
//
// Stations are numbered from 1 in the order of discovery. Station 1 is the start if a line ends there.
// Junctions are numbered from 1 in the order of discovery.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "firmware/src/nav/Explorer.h"
#include "sim/map/cells/cell_walker.h"
#include "sim/map/cells/growing_network.h"
#include "sim/map/true_graph.h"

namespace robosim::cells {

/// The result of a scan or a drive.
enum class Ending {
  complete,      ///< a scan found everything reachable, or a drive reached its destination
  lost,          ///< because of noise, the robot met a place that contradicts the graph
  out_of_moves,  ///< the limit was reached
  no_way,        ///< an obstacle blocks every path
  refused        ///< the planner cannot handle this graph; see `why`
};

struct Scan {
  Ending ending = Ending::complete;
  std::uint64_t moves = 0;
  double time = 0.0;  ///< seconds, by the robot's clock
  CellPose end;
  map::TrueGraph graph;  ///< as found; `unreachable` lists the line ends that were not found
};

struct Route {
  Ending ending = Ending::complete;
  std::string why;             ///< reason, if refused
  int from = 0, to = 0;        ///< stations
  std::vector<int> junctions;  ///< on the path
  /// One letter for each junction. Ways out are counted from the right as the robot enters: R is the first
  /// way, L the last. With three ways out, S is the way between them.
  std::string turns;
  double time = 0.0;  ///< time of this drive, seconds; its last move is the turn at the destination
  CellPose end;
  double ratio_to_shortest = 1.0;  ///< moves of this drive / moves of a shortest path on the map
};

class Survey {
 public:
  /// `robot` must stand on the line.
  explicit Survey(CellRobot& robot) : robot_(robot), start_(robot.pose()), walker_(robot) {}

  /// Scans the floor. Call it once, before all other functions.
  const Scan& scan();
  /// Puts the robot on a station, facing the line, as after a drive.
  void place_at(int station);
  /// Drives from the robot's station to another station. Both must exist.
  Route drive(int to, const std::string& planner);

  int stations() const { return static_cast<int>(scan_.graph.stations.size()); }
  /// Returns the robot's station; 0 = none.
  int here() const { return here_; }
  /// Returns the default planner.
  std::string default_planner() const;

 private:
  // Records the places of stations and obstacles, so that the graph can be compared to the map.
  struct Network : GrowingNetwork {
    struct Obstacle {
      map::CellAt cell;
      std::uint32_t moves;  ///< number of moves to the cell in front of the obstacle
    };
    const CellWalker* walker = nullptr;
    std::vector<map::CellAt> stations;  ///< in the order of their nodes
    std::map<std::pair<Id, std::uint8_t>, Obstacle> obstacles;

    Id addStation(Id from, std::uint8_t slot, std::uint8_t arms, nav::Heading entry, std::uint32_t cost) {
      stations.push_back(walker->cell());
      return GrowingNetwork::addStation(from, slot, arms, entry, cost);
    }
    bool block(Id node, std::uint8_t slot) {
      obstacles[{node, slot}] = {walker->obstacle(), walker->cost()};
      return GrowingNetwork::block(node, slot);
    }
  };
  using Id = GrowingNetwork::Id;
  struct NamedPlanner;

  // The graph of the map itself, for the lengths of shortest paths.
  struct Truth {
    map::TrueGraph graph;
    std::unordered_map<std::size_t, int> station_at;  ///< number of the station, by cell
    int from = 0;                                     ///< station from which `distances` are measured
    std::vector<int> distances;
  };

  void explore();
  void read_graph();
  void find_unreachable();
  map::Arm arm(Id node, std::uint8_t slot) const;
  Ending navigate(Id from, nav::Heading heading, Id to, const std::string& planner);
  void go_to_first_station(nav::Heading heading, Id node);
  void describe(const std::vector<Id>& way, Route& route) const;
  std::uint64_t fewest_moves(int from, int to);
  CellPose pose_at(int station) const;
  bool stands_in_wall(int station) const;

  CellRobot& robot_;
  CellPose start_;
  CellWalker walker_;
  Network network_;
  Scan scan_;
  int here_ = 0;
  std::vector<Id> station_nodes_;  ///< by number, from 1
  std::vector<int> numbers_;       ///< number of each node, among the stations or the junctions
  std::optional<Truth> truth_;
};

}  // namespace robosim::cells
