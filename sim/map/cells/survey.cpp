#include "sim/map/cells/survey.h"

#include <unordered_map>
#include <unordered_set>

#include "firmware/src/nav/Navigator.h"
#include "sim/map/cells/planners.h"

namespace robosim::cells {

using map::Arm;
using map::CellAt;
using map::Direction;
using nav::Landmark;
using nav::LandmarkKind;

namespace {

CellAt cell_of(const nav::Place& place) { return {place.x, place.y}; }

Direction direction_of(nav::Heading heading) { return static_cast<Direction>(heading); }

const char* reason(nav::Plan plan) {
  switch (plan) {
    case nav::Plan::not_a_tree:
      return "it supports only trees, but this network has cycles";
    case nav::Plan::not_preorder:
      return "it requires nodes numbered in preorder";
    default:
      return "it has no memory for this network";
  }
}

}  // namespace

const Scan& Survey::scan() {
  network_.walker = &walker_;
  try {
    explore();
  } catch (const OutOfMoves&) {
    scan_.ending = Ending::out_of_moves;
  }
  if (scan_.graph.stations.empty() && scan_.graph.junctions.empty()) read_graph();
  scan_.moves = robot_.moves();
  scan_.time = robot_.clock();
  scan_.end = robot_.pose();
  return scan_;
}

void Survey::explore() {
  nav::Explorer<CellWalker, Network> explorer(walker_, network_);
  while (explorer.step()) {
  }
  if (explorer.state() != nav::ScanState::complete) scan_.ending = Ending::lost;
  read_graph();
  if (scan_.ending == Ending::complete && network_.size() > 0)
    go_to_first_station(explorer.heading(), explorer.here());
}

Arm Survey::arm(Id node, std::uint8_t slot) const {
  Arm arm;
  arm.out = direction_of(nav::headingOf(network_, node, slot));
  const Id behind = network_.link(node, slot);
  if (behind == Network::kBlocked) {
    arm.behind = Arm::Behind::blocked;
    const auto found = network_.obstacles.find({node, slot});
    if (found != network_.obstacles.end()) {
      arm.obstacle = found->second.cell;
      arm.length = static_cast<int>(found->second.moves);
    }
  } else if (behind != Network::kNone) {
    arm.behind = network_.isStation(behind) ? Arm::Behind::station : Arm::Behind::junction;
    arm.id = numbers_[behind];
    arm.slot = network_.backSlot(node, slot);
    arm.length = static_cast<int>(network_.cost(node, slot));
    const Id station = network_.isStation(behind) ? behind : node;
    const bool found_by_driving_there =
        network_.isStation(station) && network_.parent(station) != Network::kNone;
    if (found_by_driving_there && stands_in_wall(numbers_[station])) --arm.length;
  }
  return arm;
}

// Returns whether the line ends in front of a wall at this station. At such a station the robot steps into
// the wall, as in Robosim v1.
bool Survey::stands_in_wall(int station) const {
  const Id node = station_nodes_[static_cast<std::size_t>(station)];
  const CellAt cell = network_.stations[static_cast<std::size_t>(station - 1)];
  return robot_.floor().is_wall(robot_.floor().index_of(ahead(cell, direction_of(network_.entry(node)))));
}

CellPose Survey::pose_at(int station) const {
  const CellAt cell = network_.stations[static_cast<std::size_t>(station - 1)];
  const Direction outward = direction_of(network_.entry(station_nodes_[static_cast<std::size_t>(station)]));
  return {stands_in_wall(station) ? ahead(cell, outward) : cell, reversed(outward)};
}

void Survey::read_graph() {
  map::TrueGraph& graph = scan_.graph;
  numbers_.assign(network_.size(), 0);
  station_nodes_.assign(1, Network::kNone);
  int junctions = 0;
  for (Id node = 0; node < network_.size(); ++node) {
    if (network_.isStation(node)) {
      numbers_[node] = static_cast<int>(station_nodes_.size());
      station_nodes_.push_back(node);
    } else {
      numbers_[node] = ++junctions;
    }
  }
  const map::Map& map = robot_.floor().map();
  std::unordered_map<std::size_t, std::string> names;
  for (const map::NamedStation& named : map.stations) names.emplace(map.index_of(named.cell), named.name);
  for (Id node = 0; node < network_.size(); ++node) {
    if (network_.isStation(node)) {
      map::GraphStation station;
      station.cell = network_.stations[graph.stations.size()];
      if (const auto name = names.find(map.index_of(station.cell)); name != names.end())
        station.name = name->second;
      if (network_.arms(node) != 0) station.arm = arm(node, 0);
      graph.stations.push_back(std::move(station));
    } else {
      map::GraphJunction junction{cell_of(network_.place(node)), {}};
      const std::uint8_t slots = nav::slots(network_, node);
      for (std::uint8_t slot = 0; slot < slots; ++slot) junction.arms.push_back(arm(node, slot));
      graph.junctions.push_back(std::move(junction));
    }
  }
  find_unreachable();
}

void Survey::find_unreachable() {
  const map::Map& map = robot_.floor().map();
  std::unordered_set<std::size_t> reached;
  for (const CellAt cell : network_.stations) reached.insert(map.index_of(cell));
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (!map::is_line(map.cells[i]) || reached.contains(i)) continue;
    const CellAt cell = map.cell_at(i);
    if (map::is_dead_end(map, cell)) scan_.graph.unreachable.push_back(cell);
  }
}

// A planner, selected by name, for the navigator.
struct Survey::NamedPlanner {
  std::string name;
  std::vector<Id> way;
  std::size_t at = 0;

  Id next(const GrowingNetwork& network, Id here, Id to) {
    if (way.empty()) {
      GrowingMemory path;
      if (plan(name, network, here, to, path) == nav::Plan::found) way = path.way();
      at = 0;
    }
    return at + 1 < way.size() ? way[++at] : GrowingNetwork::kNone;
  }
  void forget() { way.clear(); }
};

// Drives to a node. If the node is a station, the robot ends there facing the line.
Ending Survey::navigate(Id from, nav::Heading heading, Id to, const std::string& planner) {
  nav::Navigator<CellWalker, Network, NamedPlanner> navigator(walker_, network_,
                                                              NamedPlanner{planner, {}, 0});
  navigator.start(from, heading);
  navigator.goTo(to);
  try {
    while (navigator.step()) {
    }
  } catch (const OutOfMoves&) {
    return Ending::out_of_moves;
  }
  if (navigator.state() == nav::NavState::no_way) return Ending::no_way;
  const bool is_there = navigator.state() == nav::NavState::arrived &&
                        walker_.cell() == network_.stations[static_cast<std::size_t>(numbers_[to] - 1)];
  return is_there ? Ending::complete : Ending::lost;
}

void Survey::go_to_first_station(nav::Heading heading, Id node) {
  if (stations() == 0) return;
  here_ = 1;
  const Id first = station_nodes_[1];
  if (node == first) return;
  const Ending ending = navigate(node, heading, first, default_planner());
  if (ending == Ending::complete) return;
  here_ = ending == Ending::no_way && network_.isStation(node) ? numbers_[node] : 0;
  if (ending != Ending::no_way) scan_.ending = ending;
}

void Survey::place_at(int station) {
  robot_.place(pose_at(station));
  walker_.reset();
  here_ = station;
}

std::string Survey::default_planner() const { return cells::default_planner(network_); }

void Survey::describe(const std::vector<Id>& way, Route& route) const {
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    const Id here = way[i];
    const std::uint8_t came = network_.backSlot(way[i - 1], nav::slotTowards(network_, way[i - 1], here));
    const std::uint8_t out = nav::slotTowards(network_, here, way[i + 1]);
    const int arms = nav::slots(network_, here);
    const int rank = (out - came + arms) % arms;
    route.junctions.push_back(numbers_[here]);
    route.turns += rank == 1 ? 'R' : rank == arms - 1 ? 'L' : 'S';
  }
}

Route Survey::drive(int to, const std::string& planner) {
  Route route;
  route.from = here_;
  route.to = to;
  const Id from_node = station_nodes_[static_cast<std::size_t>(here_)];
  const Id to_node = station_nodes_[static_cast<std::size_t>(to)];
  const std::uint64_t moves_before = robot_.moves();
  const double clock_before = robot_.clock();
  GrowingMemory path;
  const nav::Plan planned = plan(planner, network_, from_node, to_node, path);
  if (planned == nav::Plan::no_way) {
    route.ending = Ending::no_way;
  } else if (planned != nav::Plan::found) {
    route.ending = Ending::refused;
    route.why = reason(planned);
  } else if (here_ != to) {
    describe(path.way(), route);
    route.ending = navigate(from_node, nav::opposite(network_.entry(from_node)), to_node, planner);
    const std::uint64_t moves = robot_.moves() - moves_before;
    const std::uint64_t fewest = fewest_moves(here_, to);
    if (fewest > 0) route.ratio_to_shortest = static_cast<double>(moves) / static_cast<double>(fewest);
    here_ = route.ending == Ending::complete ? to : 0;
  }
  route.time = robot_.clock() - clock_before;
  route.end = robot_.pose();
  return route;
}

// Returns the number of moves of a shortest path. Counts the path's cells and the turn at the destination.
// Also counts a step out of a wall at the start, and a step into a wall at the destination.
std::uint64_t Survey::fewest_moves(int from, int to) {
  const map::Map& map = robot_.floor().map();
  if (!truth_) {
    truth_ = Truth();
    truth_->graph = map::true_graph(map, {start_.cell, start_.facing});
    int number = 0;
    for (const map::GraphStation& station : truth_->graph.stations)
      truth_->station_at[map.index_of(station.cell)] = ++number;
  }
  const auto true_number = [&](int station) {
    const auto found =
        truth_->station_at.find(map.index_of(network_.stations[static_cast<std::size_t>(station - 1)]));
    return found == truth_->station_at.end() ? 0 : found->second;
  };
  const int true_from = true_number(from), true_to = true_number(to);
  if (true_from == 0 || true_to == 0) return 0;
  if (truth_->from != true_from) {
    truth_->distances = map::distances_from(truth_->graph, true_from);
    truth_->from = true_from;
  }
  const int distance = truth_->distances[static_cast<std::size_t>(true_to - 1)];
  const bool from_wall = robot_.floor().is_wall(robot_.floor().index_of(pose_at(from).cell));
  const bool to_wall = stands_in_wall(to);
  return distance < 0 ? 0
                      : static_cast<std::uint64_t>(distance) + 1 + (from_wall ? 1 : 0) + (to_wall ? 1 : 0);
}

}  // namespace robosim::cells
