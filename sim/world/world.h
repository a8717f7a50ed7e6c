// Simulates the physical world: floor, walls, bodies. One call integrates one tick.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "sim/base/vec.h"
#include "sim/map/map.h"
#include "sim/world/body.h"
#include "sim/world/floor.h"
#include "sim/world/ground.h"
#include "sim/world/lighting.h"
#include "sim/world/near_bodies.h"
#include "sim/world/radio_channel.h"
#include "sim/world/separation.h"
#include "sim/world/walls.h"

namespace robosim::world {

class World {
 public:
  /// The map must outlive the world.
  explicit World(const map::Map& map);

  const Floor& floor() const { return floor_; }
  /// Calls Floor::vary.
  void vary_floor(const NoiseStream& noise, double share) { floor_.vary(noise, share); }
  void wear_lines(const NoiseStream& noise) { floor_.wear(noise); }
  /// Returns the ground; null if the floor is a plane with one surface.
  const Ground* ground() const { return ground_.plain() ? nullptr : &ground_; }
  const Lighting& lighting() const { return lighting_; }
  /// Calls Lighting::draw_phases.
  void draw_light_phases(const NoiseStream& noise) { lighting_.draw_phases(noise); }
  /// Adds a body, and returns its number, from 0. Bodies keep their addresses. Throws std::invalid_argument
  /// (see Body).
  std::size_t add_body(const BodyParams&, const Pose&);
  /// Returns the first body with a lower number that overlaps body `number`, or nothing.
  std::optional<std::size_t> first_overlap(std::size_t number) const;
  Body& body(std::size_t number) { return *bodies_[number]; }
  const Body& body(std::size_t number) const { return *bodies_[number]; }

  /// Puts a round obstacle on the floor, and returns its number, from 1. The obstacle stops bodies; floor
  /// sensors do not see it.
  int add_obstacle(Vec2 centre, double radius_m) { return walls_.add(centre, radius_m); }
  /// Remove or move an obstacle; do nothing if it does not exist.
  void remove_obstacle(int number) { walls_.remove(number); }
  void move_obstacle(int number, Vec2 centre) { walls_.move(number, centre); }
  /// Returns the paint that is added or removed during the run.
  RuntimePaint& patches() { return floor_.patches(); }
  Lighting& lighting() { return lighting_; }

  const Walls& walls() const { return walls_; }

  /// Returns the model of radio transmission between robots.
  RadioChannel& radio() { return radio_; }

  // The next functions return the distance from a point to the nearest solid (walls.h), for a sensor of body
  // `from_body`. Other bodies count as circles about their outlines; lifted bodies do not count.
  double range_along(std::size_t from_body, Vec2 from, Vec2 direction, double most) const;
  double range_in_beam(std::size_t from_body, Vec2 from, Vec2 direction, Vec2 half_beam, double most) const;

  /// The state that changes during a run.
  struct State {
    std::vector<Body> bodies;
    Walls::State walls;
    Ground::State ground;
    RadioChannel::State radio;
    RuntimePaint::State patches;
    std::vector<bool> lights;  ///< whether each light is on
  };
  State save() const;
  /// Restores a state of this world. Bodies keep their addresses.
  void restore(const State& saved);

  /// Returns whether step() would change nothing, without outside influence.
  bool is_still() const;
  /// Integrates every body over one tick (kTick). Deterministic: uses no transcendental function of libm.
  void step();

  // The next functions step bodies that cannot affect others for a while, on a plane floor: see Separation.
  /// Returns for each body whether it stays apart from all others for `seconds`, without outside influence.
  /// Such a body neither touches nor detects another body, and no other body detects it. `sights` are the
  /// distances, m, from each axle's centre within which a body's sensors detect others.
  const std::vector<bool>& apart(const std::vector<double>& sights, double seconds) {
    return apart_.find(bodies_, sights, seconds);
  }
  void step_alone(std::size_t number) {
    bodies_[number]->step(walls_, nullptr);
    bodies_[number]->settle_contact();
  }
  /// Steps the given bodies. These must be all bodies that cannot be stepped alone.
  void step_together(const std::vector<std::size_t>& numbers);

 private:
  void step_all(Ground* ground);
  void collide_bodies();

  Floor floor_;
  Ground ground_;
  Lighting lighting_;
  Walls walls_;
  RadioChannel radio_;
  std::vector<std::unique_ptr<Body>> bodies_;
  NearBodies near_;
  Separation apart_;
};

}  // namespace robosim::world
