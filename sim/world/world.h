// The physical world: floor, walls, bodies. One call integrates one tick.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/base/vec.h"
#include "sim/grid/map.h"
#include "sim/world/floor.h"

namespace robosim::world {

/// What a motor driver makes of its pins, averaged over one tick.
struct WheelCommand {
  double drive = 0.0;  ///< -1..1: signed fraction of time (or PWM duty) with the supply across the motor
  double brake = 0.0;  ///< 0..1: fraction of time with the motor's terminals shorted; the rest is open (coasting)
};

enum Side { left = 0, right = 1 };

/// Defined in body.h by the owner of sim/world: motor constants, gear, driver's drop, wheel radius, track width,
/// mass, inertia, friction, grip, outline; every field with its unit and source.
struct BodyParams;

class Body {
 public:
  /// State at the beginning of the current tick.
  const Pose& pose() const;
  /// The pose `dt_s` into the current tick, extrapolated with constant velocities.
  Pose pose_after(double dt_s) const;
  double speed() const;           ///< m/s, forward
  double turn_rate() const;       ///< rad/s, counter-clockwise
  double wheel_angle(Side) const; ///< rad since the start, forward positive
  double wheel_rate(Side) const;  ///< rad/s
  double distance() const;        ///< m travelled by the axle's centre, always growing
  double energy() const;          ///< J drawn from the battery by the motors
  int collisions() const;         ///< contacts with walls and edges; a lasting one counts once
  bool in_contact() const;
  /// Whether the body's outline covers a point of the floor.
  bool covers(Vec2 p) const;

  void command(Side, WheelCommand);  ///< holds until the next call
  void place(const Pose&);           ///< lifted and put down, at rest
};

class World {
 public:
  explicit World(const grid::Map& map);
  const Floor& floor() const;
  std::size_t add_body(const BodyParams&, const Pose&);
  Body& body(std::size_t);
  /// Integrates every body over one tick (kTick). Deterministic; no libm transcendental.
  void step();
};

}  // namespace robosim::world
