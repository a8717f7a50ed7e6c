// Looks at the floor with one footprint, and caches what it has found. Most repeated questions then cost one
// subtraction.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "sim/base/vec.h"
#include "sim/map/stripes.h"
#include "sim/world/painted_areas.h"

namespace robosim::world {

/// An axis-parallel box on the floor, m.
struct FloorBox {
  Vec2 low, high;

  /// Returns whether p is inside the box, and not on a side. An empty box contains no point.
  bool holds(Vec2 p) const { return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y; }
  /// Reduces the box to the part at most `way` away from p.
  void keep(Vec2 p, double way);
};

/// A footprint, the one or two stripes nearest to it, and a box around the place of the last search. Inside
/// the box, no other stripe is nearer. The cache is mutable, because it never changes an answer.
class FloorProbe {
 public:
  /// `footprint_m` is the side of a square footprint. For a disc, it is the side of the square of equal area.
  FloorProbe(double footprint_m = 0.0) : footprint_(std::max(footprint_m, 1e-9)) {}
  double footprint() const { return footprint_; }

  /// Returns whether the cached stripe is valid at p. Before the first search, it is not valid anywhere.
  bool holds(Vec2 p) const { return box_.holds(p); }
  /// Returns whether the footprint reaches no stripe. Applies to all points p for which holds(p) is true.
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
    double reach;  ///< in metres; stripes that are farther away do not matter
  };
  /// Returns the distance from p, which is in the box, to the nearest stripe, m, or kNoStripe.
  double seek(const Around&, Vec2 p) const;
  /// Clears the box.
  void forget() const { box_ = {}; }
  static constexpr double kNoStripe = 1e9;

  /// The last result of Floor::painted_darkness(), and everything that it depends on.
  struct Darkness {
    Vec2 at = {std::numeric_limits<double>::quiet_NaN(), 0.0};
    Band band = Band::infrared;
    int changes = 0;  ///< RuntimePaint::changes()
    double value = 0.0;
  };
  Darkness& last_darkness() const { return darkness_; }

 private:
  enum class Kind : std::uint8_t {
    clear,
    level,    // next to a segment along x; its ends do not matter
    upright,  // next to a segment along y
    arc,      // within the arc's quarter
    two       // the nearer of two stripes, which may be the same
  };
  double distance_of_two(std::span<const map::Stripe> all, Vec2 p) const;
  void beside(const map::Stripe&, Vec2 p) const;

  double footprint_;  // m
  mutable FloorBox box_;
  mutable Vec2 at_;              // point on the segment, or the arc's centre
  mutable double radius_ = 0.0;  // m
  mutable std::uint32_t first_ = 0, second_ = 0;
  mutable Kind kind_ = Kind::two;
  mutable Darkness darkness_;
};

}  // namespace robosim::world
