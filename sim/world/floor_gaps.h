// Gaps between boards: [[joint]] of a map.
//
// A wheel of radius r rolls slowly over a gap of width g. It turns about its first edge, and then about the
// second. In the middle it has sunk by
//   h = r - sqrt(r^2 - (g/2)^2)                           for example 0.20 mm: r = 16 mm, g = 5 mm
// Its slope changes at once from -tan(alpha) to tan(alpha), with sin(alpha) = g / 2r. It meets the second
// edge with v sin(2 alpha) across it, and loses that in an impact without rebound.
//
// Above a speed of sqrt(G r), G = 9.8 m/s^2 (0.40 m/s for r = 16 mm), the wheel leaves the first edge and
// falls. With V = v / sqrt(G r) it meets the second edge g / (1 + V) before it, after sinking by 4 / (1 +
// V)^2 h at most. If g is small against r it meets the edge with sqrt(G r) g / r. So each wheel, which
// carries a mass m, loses of its kinetic energy
//   m / 2 (sin(2 alpha) min(v, sqrt(G r)))^2              in all 4 m G h at most, at any speed
//
// A wheel that rolls obliquely, by theta, reaches r |cos theta| along the gap's width. Its tread of width w
// bridges w |sin theta| of it. Robot files do not have w, so 6 mm are assumed, as narrow wheels have. A
// ball has no tread; one that is hardly wider than the gap is caught in it.
//
// Not modelled: soft tyres, which sink less and lose less; boards of different heights (a [[hill]] is a
// step); a jolt that lifts the other wheels.
#pragma once

#include <vector>

#include "sim/base/vec.h"
#include "sim/grid/course.h"

namespace robosim::world {

class FloorGaps {
 public:
  explicit FloorGaps(const grid::Course& course) : joints_(course.joints) {}
  bool empty() const { return joints_.empty(); }

  /// A rolling body: a wheel or a ball.
  struct Roller {
    double radius = 0.0;  ///< m
    Vec2 rolls;           ///< the direction in which it rolls, a unit vector; 0 for a ball
    double speed = 0.0;   ///< m/s, without a sign
  };
  struct Sunk {
    double depth = 0.0;  ///< m
    Vec2 rise;           ///< of the axle, in the world's frame: down towards the middle
  };
  /// While its contact point is p.
  Sunk sunk(Vec2 p, const Roller& roller) const;
  /// m/s across the edges that it meets on its way, from one tick to the next, sums of squares.
  double met2(Vec2 from, Vec2 to, const Roller& roller) const;

 private:
  const std::vector<grid::Joint> joints_;
};

}  // namespace robosim::world
