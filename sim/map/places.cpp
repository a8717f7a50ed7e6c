#include "sim/map/places.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "sim/map/network.h"

namespace robosim::map {
namespace {

constexpr double kUndecided_cells = 0.6;
constexpr int kSearched_cells = 3;  // on each side of a point that is off the line

}  // namespace

Places::Places(const Map& map, const Start& start) : map_(map), near_(map.cells.size()) {
  const Network network = trace_network(map, start);
  std::vector<CellAt> landmarks;
  for (const Station& station : network.stations) {
    names_.push_back("station " + station.name);
    landmarks.push_back(station.cell);
  }
  for (std::size_t i = 0; i < network.junctions.size(); ++i) {
    names_.push_back("junction " + std::to_string(i + 1));
    landmarks.push_back(network.junctions[i]);
  }
  spread(landmarks);
}

// Searches breadth first from all landmarks at once. Each cell stores the first two landmarks that reach it.
void Places::spread(const std::vector<CellAt>& landmarks) {
  struct Step {
    CellAt cell;
    std::int32_t landmark;
    std::int32_t cells;
  };
  std::deque<Step> steps;
  for (std::size_t i = 0; i < landmarks.size(); ++i)
    steps.push_back({landmarks[i], static_cast<std::int32_t>(i), 0});
  for (; !steps.empty(); steps.pop_front()) {
    const Step step = steps.front();
    Near& near = near_[map_.index_of(step.cell)];
    const std::size_t slot = near.landmark[0] == kNone ? 0 : 1;
    if (near.landmark[slot] != kNone || near.landmark[0] == step.landmark) continue;
    near.landmark[slot] = step.landmark;
    near.cells[slot] = step.cells;
    const unsigned ways = line_neighbours(map_, step.cell);
    for (int d = 0; d < 4; ++d)
      if (has(ways, static_cast<Direction>(d)))
        steps.push_back({ahead(step.cell, static_cast<Direction>(d)), step.landmark, step.cells + 1});
  }
}

CellAt Places::line_cell_near(Vec2 point) const {
  const CellAt own{static_cast<int>(std::floor(point.x / map_.cell_m)),
                   map_.height - 1 - static_cast<int>(std::floor(point.y / map_.cell_m))};
  CellAt best{-1, -1};
  double least = std::numeric_limits<double>::infinity();
  for (int dy = -kSearched_cells; dy <= kSearched_cells; ++dy)
    for (int dx = -kSearched_cells; dx <= kSearched_cells; ++dx) {
      const CellAt cell{own.x + dx, own.y + dy};
      if (!is_line(map_.at(cell))) continue;
      const double away = length(map_.centre(cell) - point);
      if (away < least) {
        least = away;
        best = cell;
      }
    }
  return best;
}

// Returns the piece of line nearest to the point, and the point's position along the piece.
Places::OnLine Places::nearest(Vec2 point) const {
  OnLine found;
  found.cell = found.next = line_cell_near(point);
  if (found.cell.x < 0) return found;
  const Vec2 from = map_.centre(found.cell);
  const unsigned ways = line_neighbours(map_, found.cell);
  for (int d = 0; d < 4; ++d) {
    if (!has(ways, static_cast<Direction>(d))) continue;
    const CellAt other = ahead(found.cell, static_cast<Direction>(d));
    const double there = dot(point - from, map_.centre(other) - from) / (map_.cell_m * map_.cell_m);
    if (there > found.along) {
      found.along = std::min(there, 1.0);
      found.next = other;
    }
  }
  return found;
}

double Places::cells_off(Vec2 point) const {
  const OnLine on = nearest(point);
  if (on.cell.x < 0) return kSearched_cells;
  const Vec2 from = map_.centre(on.cell);
  return length(from + (map_.centre(on.next) - from) * on.along - point) / map_.cell_m;
}

std::string Places::at(Vec2 point) const {
  const auto [cell, next, along] = nearest(point);
  if (cell.x < 0) return "";
  std::vector<std::pair<double, std::int32_t>> ranked;
  const auto rank = [&](CellAt of, double more) {
    const Near& near = near_[map_.index_of(of)];
    for (std::size_t i = 0; i < 2; ++i)
      if (near.landmark[i] != kNone) ranked.emplace_back(near.cells[i] + more, near.landmark[i]);
  };
  rank(cell, along);
  if (next != cell) rank(next, 1.0 - along);
  if (ranked.empty()) return "";
  std::sort(ranked.begin(), ranked.end());
  for (const auto& [away, landmark] : ranked)
    if (landmark != ranked[0].second && away - ranked[0].first < kUndecided_cells) return "";
  return names_[static_cast<std::size_t>(ranked[0].second)];
}

}  // namespace robosim::map
