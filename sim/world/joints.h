// Gaps between boards: [[joint]] of a map.
//
// A wheel of radius r that rolls slowly over a gap of width g turns about its first edge, and then about the
// second. In the middle it has sunk by
//   h = r - sqrt(r^2 - (g/2)^2)                           0.20 mm of 16 mm over 5 mm
// and its slope changes at once from -tan(alpha) to tan(alpha), with sin(alpha) = g / 2r: it meets the second
// edge with v sin(2 alpha) across it, and loses that, an impact without rebound. What is faster than sqrt(G
// r), G = 9.8 m/s^2 (0.40 m/s of 16 mm), leaves the first edge and falls: with V = v / sqrt(G r) it meets the
// second one g / (1 + V) before it, has sunk by 4 / (1 + V)^2 h at most, and where g is small against r meets
// the edge with sqrt(G r) g / r. So of its kinetic energy each wheel loses, m being the mass that it carries,
//   m / 2 (sin(2 alpha) min(v, sqrt(G r)))^2              in all 4 m G h at most, whatever its speed
//
// A wheel that rolls obliquely, by theta, reaches r |cos theta| along the gap's width, and its tread, w wide,
// bridges w |sin theta| of it. Robot files say no w: it is taken to be 6 mm, as narrow wheels have. A ball
// has no tread; one that is hardly wider than the gap is caught in it.
//
// Not modelled: soft tyres, which sink less and lose less; boards of unlike heights (a [[hill]] is a step);
// that a jolt lifts the other wheels.
#pragma once

#include <vector>

#include "sim/base/vec.h"
#include "sim/grid/course.h"

namespace robosim::world {

class Joints {
 public:
  explicit Joints(const grid::Course& course) : joints_(course.joints) {}
  bool empty() const { return joints_.empty(); }

  /// What rolls: a wheel, or a ball.
  struct Roller {
    double radius = 0.0;  ///< m
    Vec2 rolls;           ///< which way, a unit vector; of a ball 0
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
