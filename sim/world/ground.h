// Height, slope and surface of the floor: [[hill]] and [[surface]] of a map. Gaps between boards:
// floor_gaps.h.
//
// Coordinates run along the slope (grid/relief.h), so the gradient of the height h is the sine of the slope's
// angle. A wheel of radius r cannot touch every point of a profile. At s its axle is, above r, at
//   z(s) = max over s' of  h(s') + sqrt(r^2 - (s' - s)^2) - r      s' within the wheel's reach
// The maximum is exact: it is at a corner of the profile, or on a straight of slope k, which contributes
//   h(s) + r sqrt(1 + k^2) - r
// A wheel that rolls obliquely to a hill reaches r |cos| along it and r |sin| across.
//
// So a wheel meets a step of height H at r sqrt(1 - (1 - H/r)^2) before it, with the slope tan(acos(1 -
// H/r)). A wheel at rest climbs only as far as its grip allows: H <= r (1 - 1 / sqrt(1 + grip^2)), if it
// carries all of the weight. Where hills overlap, the highest counts. dz/ds is limited to 4.
//
// A seesaw is a thin, even plank on a pivot at height p, with mass M and length L:
//   (M L^2 / 12 + sum m s^2) d2(sine)/dt2 = - sum N s       m, N: mass and force at s from the pivot
// It stops when an end touches the floor. Approximations: sine for angle; masses on it move slowly along it.
//
// Not modelled: the way that a wheel gains at a crest and loses at a foot; soft ground; overhangs.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/vec.h"
#include "sim/grid/map.h"
#include "sim/world/floor_gaps.h"

namespace robosim::world {

/// The floor under a wheel.
struct Footing {
  double height = 0.0;  ///< m, of its axle over where it is on a plane floor
  Vec2 rise;            ///< its gradient, in the world's frame
};

class Ground {
 public:
  explicit Ground(const grid::Map& map);

  /// Returns whether all of it is one plane of one kind.
  bool plain() const {
    return hills_.empty() && surfaces_.empty() && surface_of_cell_.empty() && joints_.empty();
  }

  /// Returns the footing of a wheel of `radius` (m) at contact point p; it rolls along `rolls`.
  Footing under_wheel(Vec2 p, Vec2 rolls, double radius) const;
  /// Returns the footing of a ball.
  Footing under_ball(Vec2 p, double radius) const;
  /// Returns the height of the floor itself in m.
  double height(Vec2 p) const;
  /// The surface there: grip, times the robot's, and rolling resistance, which comes to its own.
  using Kind = grid::SurfaceFigures;
  Kind kind(Vec2 p) const;

  const FloorGaps& joints() const { return joints_; }

  /// Lets a mass (kg) press on p with a force (N), in this tick.
  void press(Vec2 p, double mass, double force);
  /// Seesaws move by what has pressed on them. At the end of a tick.
  void settle();
  /// Returns the greatest distance, m, by which a seesaw lifts a body in this tick.
  double heave() const;

  /// The state that changes during a run.
  struct Seesaw {
    double sine = 0.0, rate = 0.0;       ///< of the plank; positive: its end is up
    double torque = 0.0, inertia = 0.0;  ///< of what presses, in this tick
  };
  struct State {
    std::vector<Seesaw> seesaws;  ///< one for each hill; at rest if the hill is not a seesaw
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  Footing under(Vec2 p, Vec2 along, double radius, bool ball) const;

  const std::vector<grid::Hill> hills_;
  const std::vector<grid::Surface> surfaces_;
  const FloorGaps joints_;
  // The kinds of the legend, as in grid::Map.
  const std::vector<Kind> legend_surfaces_;
  const std::vector<std::uint8_t> surface_of_cell_;
  const int columns_, rows_;
  const double cell_m_;
  State state_;
};

}  // namespace robosim::world
