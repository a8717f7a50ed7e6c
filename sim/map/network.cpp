#include "sim/map/network.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

namespace robosim::map {
namespace {

constexpr double kLapStep = 0.04;  // in m: largest distance between two points of a lap on a path

// Returns the ways out of a cell for a robot that faces `d`, in the order of the right-hand walk.
std::array<Direction, 4> right_hand_order(Direction d) {
  return {turned_right(d), d, turned_left(d), reversed(d)};
}

bool passable(const Map& map, CellAt c) { return is_line(map.at(c)) && map.at(c) != Cell::obstacle; }

class Walk {
 public:
  Walk(const Map& map, const Start& start) : map_(map), reached_(map.cells.size()) { explore(start); }

  bool reached(CellAt c) const { return reached_[map_.index_of(c)]; }
  const std::vector<CellAt>& dead_ends() const { return dead_ends_; }
  const std::vector<CellAt>& junctions() const { return junctions_; }

  /// Returns the nodes in order of travel if the reached network is one closed loop.
  std::vector<CellAt> loop(const Start& start) const {
    if (!only_loops_ || edge_ends_ == 0) return {};
    std::vector<CellAt> nodes;
    const Direction first = first_step(start);
    CellAt cell = start.cell;
    Direction d = first;
    do {
      nodes.push_back(cell);
      cell = ahead(cell, d);
      d = onward(cell, d);
    } while (cell != start.cell || d != first);
    return nodes.size() * 2 == edge_ends_ ? nodes : std::vector<CellAt>{};
  }

 private:
  // Walks depth first and takes the rightmost way first. On a tree, Robosim v1 meets stations in this order.
  // Skips pending cells that another way has reached in the meantime, so that the walk ends despite cycles.
  void explore(const Start& start) {
    struct Way {
      CellAt to;
      Direction facing;
    };
    std::vector<Way> pending{{start.cell, start.facing}};
    while (!pending.empty()) {
      const auto [cell, facing] = pending.back();
      pending.pop_back();
      if (!passable(map_, cell) || reached(cell)) continue;
      reached_[map_.index_of(cell)] = true;
      const unsigned lines = line_neighbours(map_, cell);
      note(cell, lines);
      const auto order = right_hand_order(facing);
      for (auto d = order.rbegin(); d != order.rend(); ++d)
        if (has(lines, *d) && !reached(ahead(cell, *d))) pending.push_back({ahead(cell, *d), *d});
    }
  }

  void note(CellAt cell, unsigned lines) {
    const int degree = std::popcount(lines);
    edge_ends_ += static_cast<std::size_t>(degree);
    if (is_dead_end(map_, cell)) dead_ends_.push_back(cell);
    if (degree >= 3) junctions_.push_back(cell);
    if (degree != 2 && degree != 4) only_loops_ = false;
    for (int d = 0; d < 4; ++d)
      if (map_.at(ahead(cell, static_cast<Direction>(d))) == Cell::obstacle) only_loops_ = false;
  }

  // Returns the first direction of travel on a loop: straight ahead if possible, else right, left or back.
  Direction first_step(const Start& start) const {
    const unsigned lines = line_neighbours(map_, start.cell);
    for (const Direction d :
         {start.facing, turned_right(start.facing), turned_left(start.facing), reversed(start.facing)})
      if (has(lines, d)) return d;
    return start.facing;
  }
  Direction onward(CellAt cell, Direction d) const {
    const unsigned lines = line_neighbours(map_, cell);
    if (has(lines, d)) return d;
    return has(lines, turned_right(d)) ? turned_right(d) : turned_left(d);
  }

  const Map& map_;
  std::vector<bool> reached_;
  std::vector<CellAt> dead_ends_;
  std::vector<CellAt> junctions_;
  std::size_t edge_ends_ = 0;
  bool only_loops_ = true;
};

// Returns all dead ends of the map that the walk did not reach, in row order.
std::vector<CellAt> unreached_dead_ends(const Map& map, const Walk& walk) {
  std::vector<CellAt> cells;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (!is_line(map.cells[i])) continue;
    const CellAt c = map.cell_at(i);
    if (!walk.reached(c) && is_dead_end(map, c)) cells.push_back(c);
  }
  return cells;
}

// Returns the points of a lap on a closed path, beginning at the start.
std::vector<Vec2> lap_of(const Map& map, const OnPath& on) {
  const Path& path = map.course.paths[static_cast<std::size_t>(on.path)];
  if (!path.is_closed(map.line_m)) return {};
  const int count = std::max(3, static_cast<int>(std::ceil(path.length() / kLapStep)));
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double gone = path.length() * i / count;
    points.push_back(path.at(on.along + (on.backwards ? -gone : gone), true).position);
  }
  return points;
}

// Returns the network; leaves its members `unreachable` and `lap` empty.
Network network_of(const Map& map, const Start& start, const Walk& walk) {
  Network network;
  const auto add = [&](CellAt cell, std::string name) {
    const int id = static_cast<int>(network.stations.size()) + 1;
    network.stations.push_back({id, name.empty() ? std::to_string(id) : std::move(name), cell});
  };
  std::unordered_map<std::size_t, std::string> names;
  for (const NamedStation& named : map.stations) names.emplace(map.index_of(named.cell), named.name);
  const auto name_at = [&](CellAt cell) {
    const auto named = names.find(map.index_of(cell));
    return named == names.end() ? std::string() : named->second;
  };
  for (const CellAt cell : walk.dead_ends()) add(cell, name_at(cell));
  for (const NamedStation& named : map.stations)
    if (!is_dead_end(map, named.cell) && walk.reached(named.cell)) add(named.cell, named.name);
  network.junctions = walk.junctions();
  network.loop = walk.loop(start);
  return network;
}

Network lap_network(const Map& map, const OnPath& on) {
  Network network;
  network.lap = lap_of(map, on);
  return network;
}

}  // namespace

Network trace_network(const Map& map, const Start& start) {
  if (start.on_path) return lap_network(map, *start.on_path);
  const Walk walk(map, start);
  Network network = network_of(map, start, walk);
  network.unreachable = unreached_dead_ends(map, walk);
  for (const NamedStation& named : map.stations)
    if (!is_dead_end(map, named.cell) && !walk.reached(named.cell)) network.unreachable.push_back(named.cell);
  return network;
}

Network trace_reachable(const Map& map, const Start& start) {
  if (start.on_path) return lap_network(map, *start.on_path);
  return network_of(map, start, Walk(map, start));
}

}  // namespace robosim::map
