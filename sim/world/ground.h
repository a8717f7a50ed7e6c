// Models the height, slope and surface of the floor: [[hill]] and [[surface]] of a map. floor_gaps.h models
// gaps between boards.
//
// Coordinates run along the slope (sim/map/relief.h). The gradient of the height h is therefore the sine of
// the slope's angle. A wheel of radius r cannot touch every point of a profile. The height of the axle at s,
// minus r, is
//   z(s) = max over s' of  h(s') + sqrt(r^2 - (s' - s)^2) - r      s' within the wheel's reach
// The maximum is computed exactly: it is at a corner of the profile, or on a straight part of slope k, which
// contributes
//   h(s) + r sqrt(1 + k^2) - r
// A wheel at the angle theta to a hill reaches r |cos theta| along and r |sin theta| across
// the hill.
//
// A wheel therefore meets a step of height H when its axle is r sqrt(1 - (1 - H/r)^2) before the step. The
// slope of z is then tan(acos(1 - H/r)). A wheel at rest climbs only as far as its grip allows. If the wheel
// carries all of the weight, H <= r (1 - 1 / sqrt(1 + grip^2)). Where hills overlap, the highest hill counts.
// The slope dz/ds is limited to kSteepest.
//
// A seesaw is a thin, even plank on a pivot at height p, with mass M and length L:
//   (M L^2 / 12 + sum m s^2) d2(sine)/dt2 = - sum N s       m, N: mass and force at s from the pivot
// The plank stops when an end touches the floor. Approximations: sine for angle; masses on the plank move
// slowly along the plank.
//
// Not modelled: the distance that a wheel gains at a crest and loses at a foot; soft ground; overhangs.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/vec.h"
#include "sim/map/map.h"
#include "sim/world/floor_gaps.h"

namespace robosim::world {

inline constexpr double kSteepest = 4.0;  // m per m

/// The floor under a wheel.
struct Footing {
  double height = 0.0;  ///< m by which the wheel's axle is higher than on a plane floor
  Vec2 rise;            ///< gradient of the height, in the world frame
};

class Ground {
 public:
  explicit Ground(const map::Map& map);

  /// Returns whether the whole floor is one plane with one surface.
  bool plain() const {
    return hills_.empty() && surfaces_.empty() && surface_of_cell_.empty() && joints_.empty();
  }

  /// Returns the footing of a wheel of `radius` (m) that rolls along `rolls`, with contact point p.
  Footing under_wheel(Vec2 p, Vec2 rolls, double radius) const;
  /// Returns the footing of a ball.
  Footing under_ball(Vec2 p, double radius) const;
  /// Returns the height of the floor itself in m.
  double height(Vec2 p) const;
  /// A surface: a factor for the robot's grip, and a rolling resistance that is added to the robot's.
  using Kind = map::SurfaceFigures;
  Kind kind(Vec2 p) const;

  const FloorGaps& joints() const { return joints_; }

  /// Applies a mass (kg) and a force (N) to the ground at p, in this tick.
  void press(Vec2 p, double mass, double force);
  /// Moves the seesaws by the forces of press() in this tick. Must be called at the end of a tick.
  void settle();
  /// Returns the greatest distance, m, by which a seesaw lifts a body in this tick.
  double heave() const;

  /// The state that changes during a run.
  struct Seesaw {
    double sine = 0.0, rate = 0.0;       ///< sine of the plank's slope along the hill, and its rate, 1/s
    double torque = 0.0, inertia = 0.0;  ///< sums over this tick's presses
  };
  struct State {
    std::vector<Seesaw> seesaws;  ///< one for each hill; at rest if the hill is not a seesaw
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  Footing under(Vec2 p, Vec2 along, double radius, bool ball) const;

  const std::vector<map::Hill> hills_;
  const std::vector<map::Surface> surfaces_;
  const FloorGaps joints_;
  // The surfaces of the map's legend, as in map::Map.
  const std::vector<Kind> legend_surfaces_;
  const std::vector<std::uint8_t> surface_of_cell_;
  const int columns_, rows_;
  const double cell_m_;
  State state_;
};

}  // namespace robosim::world
