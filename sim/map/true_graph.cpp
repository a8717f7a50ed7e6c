#include "sim/map/true_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <queue>
#include <unordered_map>

#include "sim/base/error.h"

namespace robosim::map {
namespace {

using Behind = Arm::Behind;

bool is_junction(unsigned lines) { return std::popcount(lines) >= 3; }

// Returns the directions of a junction's arms by slot, `zero` first.
std::vector<Direction> slots_from(unsigned lines, Direction zero) {
  std::vector<Direction> slots;
  Direction d = zero;
  do {
    if (has(lines, d)) slots.push_back(d);
    d = turned_left(d);
  } while (d != zero);
  return slots;
}

// The place of a robot that has followed a line to its end.
struct Arrival {
  Behind met = Behind::nothing;  // nothing = back at the beginning without having met a node or an obstacle
  CellAt cell;
  Direction facing = Direction::east;
  int moves = 0;
};

Arrival follow(const Map& map, CellAt from, Direction d) {
  Arrival at{Behind::nothing, from, d, 0};
  const Direction first = d;
  do {
    if (blocks_line(map, at.cell, at.facing)) {
      at.met = Behind::blocked;
      return at;
    }
    at.cell = ahead(at.cell, at.facing);
    ++at.moves;
    const unsigned lines = line_neighbours(map, at.cell);
    if (is_junction(lines)) at.met = Behind::junction;
    if (is_dead_end(map, at.cell)) at.met = Behind::station;
    if (at.met != Behind::nothing) return at;
    if (has(lines, at.facing) || std::has_single_bit(lines)) continue;
    at.facing = has(lines, turned_right(at.facing)) ? turned_right(at.facing) : turned_left(at.facing);
  } while (at.cell != from || at.facing != first);
  return at;
}

class Survey {
 public:
  Survey(const Map& map, const Start& start) : map_(map) {
    find_root(start);
    while (!open_.empty()) explore_next();
    for (const NamedStation& named : map.stations) {
      const auto found = known_.find(map.index_of(named.cell));
      if (found != known_.end() && is_dead_end(map, named.cell))
        graph_.stations[static_cast<std::size_t>(found->second - 1)].name = named.name;
    }
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
      const CellAt cell = map.cell_at(i);
      if (is_line(map.cells[i]) && is_dead_end(map, cell) && !known_.contains(i))
        graph_.unreachable.push_back(cell);
    }
  }

  TrueGraph take() { return std::move(graph_); }

 private:
  // A node with arms that have not been walked yet.
  struct Open {
    Behind kind;
    int id;
    std::size_t next;  // next slot to walk: 1, 2, …, then 0
  };

  void find_root(const Start& start) {
    const unsigned lines = line_neighbours(map_, start.cell);
    const Direction d = start.facing;
    std::optional<Direction> first, last;
    for (const Direction way : {turned_right(d), d, turned_left(d), reversed(d)}) {
      if (!has(lines, way)) continue;
      if (!first) first = way;
      last = way;
    }
    if (is_dead_end(map_, start.cell)) {
      add_station(start.cell, first);
    } else if (is_junction(lines)) {
      add_junction(start.cell, *last);
    } else {
      Arrival at = follow(map_, start.cell, *first);
      if (at.met == Behind::blocked) {
        const unsigned back = line_neighbours(map_, at.cell) & ~(1u << static_cast<int>(at.facing));
        if (back == 0) return;
        at = follow(map_, at.cell, static_cast<Direction>(std::countr_zero(back)));
      }
      if (at.met == Behind::station) add_station(at.cell, reversed(at.facing));
      if (at.met == Behind::junction) add_junction(at.cell, reversed(at.facing));
    }
  }

  // Throws InputError if there are too many nodes for the size of the map. A node uses about 400 bytes of
  // memory, and about 400 bytes of text output. A cell uses one byte.
  void check_count() const {
    constexpr std::size_t kAlways = 100'000, kCellsEach = 8, kMost = 300'000;
    const std::size_t most = std::min(kAlways + map_.cells.size() / kCellsEach, kMost);
    if (graph_.stations.size() + graph_.junctions.size() < most) return;
    throw InputError({map_.file},
                     fmt::format("the line has too many stations and junctions for a graph: "
                                 "expected at most {} ({} and one for each {} cells, but no more than {})",
                                 most, kAlways, kCellsEach, kMost));
  }

  int add_station(CellAt cell, std::optional<Direction> out) {
    check_count();
    graph_.stations.push_back({cell, "", {}});
    if (out) graph_.stations.back().arm.out = *out;
    const int id = static_cast<int>(graph_.stations.size());
    known_[map_.index_of(cell)] = id;
    if (out) open_.push_back({Behind::station, id, 0});
    return id;
  }

  int add_junction(CellAt cell, Direction zero) {
    check_count();
    GraphJunction junction{cell, {}};
    const std::vector<Direction> slots = slots_from(line_neighbours(map_, cell), zero);
    junction.arms.reserve(slots.size());
    for (const Direction out : slots) junction.arms.push_back({out, Behind::nothing, 0, 0, 0, {}});
    graph_.junctions.push_back(std::move(junction));
    const int id = static_cast<int>(graph_.junctions.size());
    known_[map_.index_of(cell)] = id;
    open_.push_back({Behind::junction, id, 1});
    return id;
  }

  CellAt cell_of(const Open& node) const {
    const auto i = static_cast<std::size_t>(node.id - 1);
    return node.kind == Behind::station ? graph_.stations[i].cell : graph_.junctions[i].cell;
  }
  Arm& arm_of(Behind kind, int id, std::size_t slot) {
    const auto i = static_cast<std::size_t>(id - 1);
    return kind == Behind::station ? graph_.stations[i].arm : graph_.junctions[i].arms[slot];
  }

  void explore_next() {
    Open& node = open_.back();
    const std::size_t count = node.kind == Behind::station
                                  ? 1
                                  : graph_.junctions[static_cast<std::size_t>(node.id - 1)].arms.size();
    if (node.next > count) {
      open_.pop_back();
      return;
    }
    const std::size_t slot = node.next++ % count;
    const Open from = node;
    Arm& arm = arm_of(from.kind, from.id, slot);
    if (arm.behind != Behind::nothing) return;
    const Arrival at = follow(map_, cell_of(from), arm.out);
    if (at.met == Behind::blocked) {
      arm.behind = Behind::blocked;
      arm.length = at.moves;
      arm.obstacle = ahead(at.cell, at.facing);
      return;
    }
    const auto found = known_.find(map_.index_of(at.cell));
    int id = found == known_.end() ? 0 : found->second;
    if (id == 0)
      id = at.met == Behind::station ? add_station(at.cell, reversed(at.facing))
                                     : add_junction(at.cell, reversed(at.facing));
    join(from, slot, at, id);
  }

  void join(const Open& from, std::size_t slot, const Arrival& at, int id) {
    std::size_t other = 0;
    while (arm_of(at.met, id, other).out != reversed(at.facing)) ++other;
    Arm& near = arm_of(from.kind, from.id, slot);
    Arm& far = arm_of(at.met, id, other);
    near = {near.out, at.met, id, static_cast<int>(other), at.moves, {}};
    far = {far.out, from.kind, from.id, static_cast<int>(slot), at.moves, {}};
  }

  const Map& map_;
  TrueGraph graph_;
  std::unordered_map<std::size_t, int> known_;  // number of the station or junction at a cell
  std::vector<Open> open_;
};

// Visits all arms of a graph, together with the cell of each arm's node.
template <typename Visit>
void for_each_arm(const TrueGraph& graph, Visit visit) {
  for (const GraphStation& station : graph.stations)
    if (station.arm.behind != Behind::nothing) visit(station.cell, station.arm);
  for (const GraphJunction& junction : graph.junctions)
    for (const Arm& arm : junction.arms) visit(junction.cell, arm);
}

}  // namespace

TrueGraph true_graph(const Map& map, const Start& start) {
  require_cells(map, start, "the graph");
  return Survey(map, start).take();
}

std::size_t line_count(const TrueGraph& graph) {
  std::size_t ends = 0;
  for_each_arm(graph, [&](CellAt, const Arm& arm) { ends += arm.behind == Behind::blocked ? 2 : 1; });
  return ends / 2;
}

std::size_t cycle_count(const TrueGraph& graph) {
  const std::size_t nodes = graph.stations.size() + graph.junctions.size();
  if (nodes == 0) return 0;
  std::size_t ends = 0;
  for_each_arm(graph, [&](CellAt, const Arm& arm) { ends += arm.behind == Behind::blocked ? 0 : 1; });
  return ends / 2 + 1 - nodes;
}

std::vector<int> distances_from(const TrueGraph& graph, int station) {
  const std::size_t stations = graph.stations.size();
  const auto node_of = [&](Behind kind, int id) {
    return static_cast<std::size_t>(id - 1) + (kind == Behind::station ? 0 : stations);
  };
  std::vector<int> distance(stations + graph.junctions.size(), -1);
  using Reached = std::pair<int, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  queue.emplace(0, node_of(Behind::station, station));
  while (!queue.empty()) {
    const auto [so_far, node] = queue.top();
    queue.pop();
    if (distance[node] >= 0) continue;
    distance[node] = so_far;
    const auto reach = [&, here = so_far](const Arm& arm) {
      if (arm.behind == Behind::station || arm.behind == Behind::junction)
        queue.emplace(here + arm.length, node_of(arm.behind, arm.id));
    };
    if (node < stations)
      reach(graph.stations[node].arm);
    else
      for (const Arm& arm : graph.junctions[node - stations].arms) reach(arm);
  }
  distance.resize(stations);
  return distance;
}

namespace {

// An arm described by cells, without the numbers of nodes and slots.
struct PlacedArm {
  CellAt from;
  Direction out;
  Behind behind;
  CellAt to;  // the node or obstacle
  int length;
  bool operator==(const PlacedArm&) const = default;
};

std::string text_of(CellAt cell) { return fmt::format("{},{}", cell.x, cell.y); }

bool row_order(CellAt a, CellAt b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

std::vector<PlacedArm> placed(const TrueGraph& graph) {
  std::vector<PlacedArm> arms;
  for_each_arm(graph, [&](CellAt from, const Arm& arm) {
    CellAt to = arm.obstacle;
    const auto i = static_cast<std::size_t>(arm.id - 1);
    if (arm.behind == Behind::station) to = graph.stations.at(i).cell;
    if (arm.behind == Behind::junction) to = graph.junctions.at(i).cell;
    arms.push_back({from, arm.out, arm.behind, to, arm.length});
  });
  std::sort(arms.begin(), arms.end(), [](const PlacedArm& a, const PlacedArm& b) {
    return a.from != b.from ? row_order(a.from, b.from) : a.out < b.out;
  });
  return arms;
}

std::string describe(const PlacedArm& arm) {
  const char* words[] = {"nothing known", "the station at ", "the junction at ", "an obstacle at "};
  std::string text = fmt::format("the line from {} to the {} leads to {}", text_of(arm.from), letter(arm.out),
                                 words[static_cast<int>(arm.behind)]);
  if (arm.behind != Behind::nothing) text += fmt::format("{} in {} moves", text_of(arm.to), arm.length);
  return text;
}

template <typename Nodes>
std::vector<CellAt> cells_of(const Nodes& nodes) {
  std::vector<CellAt> cells;
  for (const auto& node : nodes) cells.push_back(node.cell);
  std::sort(cells.begin(), cells.end(), row_order);
  return cells;
}

std::string difference(const char* what, std::vector<CellAt> expected, std::vector<CellAt> found) {
  std::sort(expected.begin(), expected.end(), row_order);
  std::sort(found.begin(), found.end(), row_order);
  const auto twice = std::adjacent_find(found.begin(), found.end());
  if (twice != found.end())
    return fmt::format("the {} at {} was found more than once", what, text_of(*twice));
  std::vector<CellAt> missing, added;
  std::set_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                      std::back_inserter(missing), row_order);
  std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(added),
                      row_order);
  if (!missing.empty()) return fmt::format("{} at {} is missing", what, text_of(missing[0]));
  if (!added.empty()) return fmt::format("there is no {} at {}", what, text_of(added[0]));
  return "";
}

}  // namespace

std::string difference(const TrueGraph& expected, const TrueGraph& found) {
  for (const std::string& text :
       {difference("station", cells_of(expected.stations), cells_of(found.stations)),
        difference("junction", cells_of(expected.junctions), cells_of(found.junctions)),
        difference("unreachable station", expected.unreachable, found.unreachable)})
    if (!text.empty()) return text;
  const std::vector<PlacedArm> right = placed(expected);
  const std::vector<PlacedArm> other = placed(found);
  for (std::size_t i = 0; i < std::min(right.size(), other.size()); ++i)
    if (right[i] != other[i]) return fmt::format("{}; found: {}", describe(right[i]), describe(other[i]));
  if (right.size() != other.size())
    return fmt::format("{} ends of lines were found instead of {}", other.size(), right.size());
  return "";
}

}  // namespace robosim::map
