// Caches the lines near a place, where corners are round. For repeated queries of a floor, most then cost one
// subtraction. It covers the map's own lines, which do not change.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "sim/base/vec.h"
#include "sim/grid/stripes.h"

namespace robosim::world {

/// An axis-parallel box on the floor, m.
struct FloorBox {
  Vec2 low, high;

  /// Returns whether p is inside, not on a side. An empty box holds nothing.
  bool holds(Vec2 p) const { return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y; }
  /// Keeps what is at most `way` away from p.
  void keep(Vec2 p, double way);
};

/// The nearest stripe of one place, and the box around that place in which it stays the nearest.
class NearStripe {
 public:
  /// Returns whether the result at p is known. Before the first search it is not.
  bool holds(Vec2 p) const { return box_.holds(p); }
  /// Returns, where it holds, whether no stripe comes near the footprint for which it was sought.
  bool is_clear() const { return kind_ == Kind::clear; }
  /// Returns the distance from the nearest stripe in m, where it holds and is not clear. The bits are
  /// grid::distance's.
  double distance(std::span<const grid::Stripe> all, Vec2 p) const {
    if (kind_ == Kind::level) return std::fabs(p.y - at_.y);
    if (kind_ == Kind::upright) return std::fabs(p.x - at_.x);
    if (kind_ == Kind::arc) return std::fabs(length(p - at_) - radius_);
    return distance_of_two(all, p);
  }

  /// The relevant stripes of a part of the floor.
  struct Around {
    std::span<const grid::Stripe> all;
    std::span<const std::uint32_t> near;  ///< the stripes that can be nearest inside the box
    FloorBox box;
    bool painted_only;
    double reach;  ///< m: stripes that are farther away do not matter
  };
  /// Returns the distance from p, which is in the box, to the nearest stripe, m, or kNoStripe.
  double seek(const Around&, Vec2 p);
  static constexpr double kNoStripe = 1e9;

 private:
  enum class Kind : std::uint8_t {
    clear,
    level,    // beside a segment along x: its ends do not matter
    upright,  // along y
    arc,      // within its quarter
    two       // the nearest of these two, which may be one
  };
  double distance_of_two(std::span<const grid::Stripe> all, Vec2 p) const;
  void beside(const grid::Stripe&, Vec2 p);

  FloorBox box_;
  Vec2 at_;              // on the segment; the arc's centre
  double radius_ = 0.0;  // m
  std::uint32_t first_ = 0, second_ = 0;
  Kind kind_ = Kind::two;
};

}  // namespace robosim::world
