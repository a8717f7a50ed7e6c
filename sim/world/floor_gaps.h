// Models gaps between boards: [[joint]] of a map.
//
// A wheel of radius r rolls slowly over a gap of width g. The wheel turns about the gap's first edge, and
// then about the second. In the middle the wheel has sunk by
//   h = r - sqrt(r^2 - (g/2)^2)                           for example 0.20 mm: r = 16 mm, g = 5 mm
// The slope of its path changes at once from -tan(alpha) to tan(alpha), with sin(alpha) = g / 2r. The wheel
// meets the second edge with the speed v sin(2 alpha) towards that edge. The wheel loses this speed in an
// impact without rebound.
//
// If the wheel is faster than sqrt(G r), it leaves the first edge and falls. Here G is 9.8 m/s^2, so the
// limit is 0.40 m/s for r = 16 mm. With V = v / sqrt(G r), the wheel touches the second edge when its axle is
// g / (1 + V) before that edge. The wheel has then sunk by at most 4 / (1 + V)^2 h. If g is small compared to
// r, the wheel's speed towards the edge is sqrt(G r) g / r. A wheel that carries a mass m loses the kinetic
// energy
//   m / 2 (sin(2 alpha) min(v, sqrt(G r)))^2              at most 4 m G h, at any speed
//
// A wheel that rolls at the angle theta to the gap's width reaches r |cos theta| along that width. Its tread
// of width w bridges w |sin theta| of the gap's width. Robot files do not contain w; 6 mm are assumed, as for
// narrow wheels. A ball has no tread. A ball that is hardly wider than the gap is caught.
//
// Not modelled: soft tyres, which sink less and lose less; boards of different heights (use a [[hill]] as a
// step); a jolt that lifts the other wheels.
#pragma once

#include <vector>

#include "sim/base/vec.h"
#include "sim/map/course.h"

namespace robosim::world {

class FloorGaps {
 public:
  explicit FloorGaps(const map::Course& course) : joints_(course.joints) {}
  bool empty() const { return joints_.empty(); }

  /// A rolling body: a wheel or a ball.
  struct Roller {
    double radius = 0.0;  ///< m
    Vec2 rolls;           ///< the direction in which it rolls, a unit vector; 0 for a ball
    double speed = 0.0;   ///< m/s, magnitude
  };
  struct Sunk {
    double depth = 0.0;  ///< m
    Vec2 rise;           ///< gradient of the axle's height in the world frame; down towards the middle
  };
  /// Returns how far a roller with contact point p has sunk into a gap.
  Sunk sunk(Vec2 p, const Roller& roller) const;
  /// Returns the sum of the squared speeds, (m/s)^2, with which the roller meets edges between two points.
  /// The points are those of successive ticks.
  double met2(Vec2 from, Vec2 to, const Roller& roller) const;

 private:
  const std::vector<map::Joint> joints_;
};

}  // namespace robosim::world
