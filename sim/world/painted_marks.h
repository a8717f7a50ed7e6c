// Bars painted on the floor: [[mark]] of a map.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/grid/map.h"
#include "sim/world/tiles.h"

namespace robosim::world {

class PaintedMarks {
 public:
  explicit PaintedMarks(const grid::Map& map);

  bool empty() const { return marks_.empty(); }
  /// Whether a square of side `footprint` about p may see one.
  bool any_near(Vec2 p, double footprint) const {
    return footprint > kLookedUpFootprint ? !marks_.empty() : !near_.at(p).empty();
  }
  /// The share of a square of side `footprint` about p that lies on marks, 0..1: exact where it is parallel
  /// to the mark.
  double coverage(Vec2 p, double footprint) const;
  /// The same for those of each paint that is met: its number's value in `most` is raised to it, from 0 where
  /// its bit in `met` is not set, and its bit is set.
  void raise(Vec2 p, double footprint, double* most, std::uint64_t& met) const;

 private:
  /// Calls visit(mark, share) for those near.
  template <class Visit>
  void visit_near(Vec2 p, double footprint, Visit visit) const;

  static constexpr double kLookedUpFootprint = 0.016;  // m; larger ones look at all marks

  const double wide_, high_;  // m, the floor
  std::vector<grid::Mark> marks_;
  std::vector<double> reaches_;  // m, from a mark's middle to its corners
  Tiles near_;
};

}  // namespace robosim::world
