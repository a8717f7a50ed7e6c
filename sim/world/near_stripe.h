// Caches the lines near a place, for maps with round corners. Most repeated queries of a floor then cost one
// subtraction. The cache covers the map's own lines, which do not change.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "sim/base/vec.h"
#include "sim/map/stripes.h"

namespace robosim::world {

/// An axis-parallel box on the floor, m.
struct FloorBox {
  Vec2 low, high;

  /// Returns whether p is inside the box, and not on a side. An empty box contains no point.
  bool holds(Vec2 p) const { return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y; }
  /// Reduces the box to the part at most `way` away from p.
  void keep(Vec2 p, double way);
};

/// The stripe nearest to a place, and a box around the place. Inside the box, this stripe stays the nearest.
class NearStripe {
 public:
  /// Returns whether the cached result is valid at p. Before the first search, it is not valid anywhere.
  bool holds(Vec2 p) const { return box_.holds(p); }
  /// Returns whether the footprint of the search reaches no stripe. Requires holds(p).
  bool is_clear() const { return kind_ == Kind::clear; }
  /// Returns the distance to the nearest stripe, m, equal bit for bit to map::distance. Requires holds(p) and
  /// !is_clear().
  double distance(std::span<const map::Stripe> all, Vec2 p) const {
    if (kind_ == Kind::level) return std::fabs(p.y - at_.y);
    if (kind_ == Kind::upright) return std::fabs(p.x - at_.x);
    if (kind_ == Kind::arc) return std::fabs(length(p - at_) - radius_);
    return distance_of_two(all, p);
  }

  /// The relevant stripes of a part of the floor.
  struct Around {
    std::span<const map::Stripe> all;
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
    level,    // next to a segment along x; its ends do not matter
    upright,  // next to a segment along y
    arc,      // within the arc's quarter
    two       // the nearer of two stripes, which may be the same
  };
  double distance_of_two(std::span<const map::Stripe> all, Vec2 p) const;
  void beside(const map::Stripe&, Vec2 p);

  FloorBox box_;
  Vec2 at_;              // point on the segment, or the arc's centre
  double radius_ = 0.0;  // m
  std::uint32_t first_ = 0, second_ = 0;
  Kind kind_ = Kind::two;
};

}  // namespace robosim::world
