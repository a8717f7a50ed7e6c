// Bars painted on the floor: [[mark]] of a map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
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
  /// The same for those of each paint: its number's value in `most` is raised to it.
  void raise(Vec2 p, double footprint, std::span<double> most) const;

 private:
  /// Calls visit(mark, share) for those near.
  template <class Visit>
  void visit_near(Vec2 p, double footprint, Visit visit) const;

  const grid::Map* map_;
  std::vector<grid::Mark> marks_;
  std::vector<std::pair<std::size_t, std::uint32_t>> near_;  // cell, mark: all within kReach, in order
};

}  // namespace robosim::world
