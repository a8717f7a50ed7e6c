// Models bars painted on the floor: [[mark]] of a map.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/map/map.h"
#include "sim/world/visibility_grid.h"

namespace robosim::world {

class PaintedMarks {
 public:
  explicit PaintedMarks(const map::Map& map);

  bool empty() const { return marks_.empty(); }
  std::size_t paint(std::size_t mark) const { return static_cast<std::size_t>(marks_[mark].paint); }
  /// Returns the share of a square of side `footprint` about p that lies on a mark. The result is exact if
  /// the square is parallel to the mark.
  double share(std::size_t mark, Vec2 p, double footprint) const {
    const Vec2 own = marks_[mark].middle.to_body(p);
    return within(own.x, marks_[mark].half_length, footprint) *
           within(own.y, marks_[mark].half_width, footprint);
  }
  /// Calls visit(mark) for all marks that a square of side `footprint` about p may reach. Does nothing if p
  /// is outside the map.
  template <typename Visit>
  void visit_near(Vec2 p, double footprint, Visit visit) const {
    if (!(p.x >= 0.0 && p.y >= 0.0 && p.x < wide_ && p.y < high_)) return;
    if (footprint > kLookedUpFootprint)
      for (std::size_t i = 0; i < marks_.size(); ++i) visit(i);
    else
      for (const std::uint32_t i : near_.at(p)) visit(i);
  }
  /// Returns the largest share() of any mark.
  double coverage(Vec2 p, double footprint) const;

 private:
  static double within(double away, double half, double footprint) {
    const double from = std::max(away - 0.5 * footprint, -half);
    const double to = std::min(away + 0.5 * footprint, half);
    return std::max(to - from, 0.0) / footprint;
  }
  static constexpr double kLookedUpFootprint = 0.016;  // m; for larger footprints, all marks are checked

  const double wide_, high_;  // m; the floor's size
  std::vector<map::Mark> marks_;
  VisibilityGrid near_;
};

}  // namespace robosim::world
