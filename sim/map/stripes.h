// The painted lines of a map as geometry: segments between centres of line cells, and arcs where `corner`
// rounds a bend. The floor's reflectance and the cross-track error are computed from these stripes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/map/map.h"
#include "sim/map/stripe_index.h"

namespace robosim::map {

/// A piece of centre line, in the world frame (m).
///
/// A segment runs towards increasing x or, if `a` and `b` have equal x, towards increasing y. If a line is a
/// single cell, `a` and `b` are equal. Only segments of a [[path]] can be oblique. An arc runs
/// counter-clockwise from `a` to `b`, for at most a quarter of a circle. The arc is tangent to the segments
/// that it joins.
struct Stripe {
  Vec2 a;               ///< one end
  Vec2 b;               ///< the other end
  Vec2 centre;          ///< centre of the arc's circle
  double radius = 0.0;  ///< radius of the arc; 0 = a straight segment
  /// False across gap cells, where the line is invisible but still counts as line. A gap is as long as its
  /// cells. Neighbouring stripes end half a line's width earlier, since paint reaches this far beyond a
  /// stripe's end.
  bool painted = true;
  std::uint8_t paint = 0;  ///< index in paints_of()
};

/// Returns the distance in m from p to the nearest point of a stripe. May be called inside a tick: it uses no
/// trigonometry, whose results can differ between machines.
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

/// A bend with a reduced radius, because its legs are too short for the map's corner radius.
struct TightBend {
  CellAt cell;
  double radius_m;  ///< reduced radius; two bends share the leg between them equally
};

/// Returns the tight bends of a map in row order, without building its stripes.
std::vector<TightBend> tight_bends(const Map& map);

/// All stripes of a map, and an index of the stripes within reach of each cell. Building them takes time and
/// memory proportional to the length of line, so read_map() does not build them.
class Stripes {
 public:
  /// Builds all stripes. A query in a cell finds every stripe within `reach_m` of any point of the cell. The
  /// map must outlive this object. Throws InputError if the map has too much line for one index (2^32
  /// entries).
  Stripes(const Map& map, double reach_m);

  std::span<const Stripe> all() const { return stripes_; }
  /// Returns indices into all(), ascending, of the stripes within reach of any point of the cell; empty
  /// outside the map.
  std::span<const std::uint32_t> near(CellAt cell) const { return index_.near(cell); }
  /// Returns the point of the centre line that represents a line cell. It is the cell's centre or, where an
  /// arc cuts the corner, the arc's point nearest to the centre.
  Vec2 point_of(CellAt cell) const;
  /// Returns the pose of a robot at `start`.
  Pose pose_of(const Start& start) const;
  const std::vector<TightBend>& tight_bends() const { return tight_; }

 private:
  std::vector<Stripe> stripes_;
  std::vector<TightBend> tight_;
  StripeIndex index_;
  const Map* map_;
};

}  // namespace robosim::map
