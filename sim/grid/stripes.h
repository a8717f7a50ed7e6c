// The painted lines of a map as geometry: segments between centres of line cells, and arcs where `corner`
// rounds a bend. The floor's reflectance and the cross-track error are both measured against them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/grid/map.h"
#include "sim/grid/stripe_index.h"

namespace robosim::grid {

/// A piece of centre line, in the world frame (m).
///
/// A segment goes from its smaller to its larger x, or y if x is the same; a and b are equal if a line is a
/// single cell. Segments of cells are parallel to an axis. An arc is at most a quarter of a circle, from a
/// to b counter-clockwise. It is tangent to the segments that it joins.
struct Stripe {
  Vec2 a;               ///< one end
  Vec2 b;               ///< the other end
  Vec2 centre;          ///< of the arc's circle
  double radius = 0.0;  ///< of the arc; 0 = a straight segment
  /// False across gap cells, where the line is not visible but still counts as line. A gap is as long as its
  /// cells: the neighbouring stripes end line/2 earlier, as the paint around an end reaches line/2 beyond it.
  bool painted = true;
  std::uint8_t paint = 0;  ///< its number in paints_of
};

/// Returns the distance from p to the nearest point of a stripe, m. No trigonometry: safe inside a tick.
inline double distance(const Stripe& s, Vec2 p) {
  if (s.radius == 0.0) {
    if (s.a.x != s.b.x && s.a.y != s.b.y) {
      const Vec2 along = s.b - s.a;
      const double share = std::clamp(dot(p - s.a, along) / dot(along, along), 0.0, 1.0);
      return length(p - s.a - along * share);
    }
    const double dx = std::max(std::max(s.a.x - p.x, p.x - s.b.x), 0.0);
    const double dy = std::max(std::max(s.a.y - p.y, p.y - s.b.y), 0.0);
    return std::sqrt(dx * dx + dy * dy);
  }
  const Vec2 w = p - s.centre;
  if (cross(s.a - s.centre, w) >= 0.0 && cross(w, s.b - s.centre) >= 0.0)
    return std::fabs(length(w) - s.radius);
  const Vec2 pa = p - s.a;
  const Vec2 pb = p - s.b;
  return std::sqrt(std::min(dot(pa, pa), dot(pb, pb)));
}

/// A bend whose legs are too short for the map's corner radius, and which has a smaller one.
struct TightBend {
  CellAt cell;
  double radius_m;  ///< what fits: a leg between two bends is shared equally
};

/// Returns the tight bends of a map in row order, without building its stripes.
std::vector<TightBend> tight_bends(const Map& map);

/// All stripes, and for each cell those within reach of it. Time and memory are proportional to the length of
/// line, so they are built for driven robots only.
class Stripes {
 public:
  /// Builds all stripes. A query point in a cell finds every stripe within `reach_m` of it. The map must
  /// outlive this. Throws InputError if the map has too much line for one index (2^32 entries).
  Stripes(const Map& map, double reach_m);

  std::span<const Stripe> all() const { return stripes_; }
  /// Returns indices into all(), ascending, of the stripes within reach of any point of the cell; empty
  /// outside the map.
  std::span<const std::uint32_t> near(CellAt cell) const { return index_.near(cell); }
  /// Returns the point of the centre line that represents a line cell: its centre, or, where an arc cuts the
  /// corner, the arc's nearest point to it.
  Vec2 point_of(CellAt cell) const;
  /// Returns the pose of a robot that starts there.
  Pose pose_of(const Start& start) const;
  const std::vector<TightBend>& tight_bends() const { return tight_; }

 private:
  std::vector<Stripe> stripes_;
  std::vector<TightBend> tight_;
  StripeIndex index_;
  const Map* map_;
};

}  // namespace robosim::grid
