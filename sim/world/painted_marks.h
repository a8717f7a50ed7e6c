// Bars painted on the floor: [[mark]] of a map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/grid/map.h"

namespace robosim::world {

class PaintedMarks {
 public:
  explicit PaintedMarks(const grid::Map& map);

  bool empty() const { return marks_.empty(); }
  /// The share of a square of side `footprint` about p that lies on marks, 0..1: exact where it is parallel
  /// to the mark.
  double coverage(Vec2 p, double footprint) const;

 private:
  const grid::Map* map_;
  std::vector<grid::Mark> marks_;
  std::vector<std::pair<std::size_t, std::uint32_t>> near_;  // cell, mark: all within kReach, in order
};

}  // namespace robosim::world
