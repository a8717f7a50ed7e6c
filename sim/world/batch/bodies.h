// Simulates many bodies, each as if it were alone on one floor. A search uses a batch to simulate one
// body many times, with different parameters or commands.
//
// A tick of a rolling body (sim/world/body.h) takes about a hundred additions and multiplications. Each
// operation needs the result of the previous one. A batch therefore computes each operation for a block of
// bodies at once (lanes.h). The order of operations is that of world::Body, so all bits of the results are
// equal. Blocks are used for the usual state of a body: both tyres roll, both wheels keep their direction,
// and no obstacle is near. In each tick, each body is tested for this state.
//
// If a body starts, stops, slips, skids, or comes near a wall in a tick, the code of world::Body simulates
// that tick. The same code simulates all ticks of special bodies (windings with inductance, steered wheels,
// wheels that skid, loads that shift). rolling_step.h computes the tick of a rolling body, also of a single
// one.
// tests/unit/batch/batch_test.cpp compares batches with single bodies, bit by bit.
//
// Bodies of a batch neither detect nor touch each other.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/world/batch/lanes.h"
#include "sim/world/body.h"
#include "sim/world/world.h"

namespace robosim::batch {

/// The state of a block's bodies. The names are those of Rolling (sim/world/rolling_step.h).
struct BodyMotion {
  Lanes x, y, heading_x, heading_y;  // m; unit vector
  Lanes v, u, omega;                 // m/s, m/s, rad/s
  Lanes surface[2], angle[2];        // m/s, rad
  Lanes wheel_travel, distance;      // m
  Lanes energy;                      // J
  Lanes free_way;                    // m
  Lanes slips;                       // 1 = yes

  /// Copies the state of the body in `lane` from another object.
  void take(const BodyMotion&, std::size_t lane);
};

/// The properties of a block's bodies. The names are those of Roller.
struct BodyBlock : BodyMotion {
  // Computed from the commands.
  Lanes direction[2], drives[2];          // sign of `drive`, and its amount
  Lanes push[2], drag[2], push_until[2];  // while the motor is driven
  Lanes brake_push[2], brake_drag[2], brake_from[2];
  // Copied from the bodies.
  Lanes per_radius[2], inertia[2], turning_friction[2], joule0[2], joule1[2], side_share[2];
  Lanes owns[2], grip_squares[2], skids_from;
  Lanes mass, mass_own, mass_cross, half_track, per_track, bound_radius, way_per_travel, stride;
  Lanes rolls;  // 1 = the body touches nothing and may use rolling_step.h
};

class Bodies {
 public:
  /// `world` is not changed, and must outlive this object. Throws std::invalid_argument if the map has hills,
  /// surfaces or gaps between boards.
  explicit Bodies(const world::World& world);

  /// Adds a body and returns its number, from 0. Throws std::invalid_argument (see world::Body).
  std::size_t add(const world::BodyParams&, const Pose&);
  std::size_t size() const { return bodies_.size(); }

  /// Command a motor and place a body, like the functions of world::Body.
  void command(std::size_t number, world::Side, const world::WheelCommand&);
  void place(std::size_t number, const Pose&);

  /// Simulates one tick of all bodies.
  void step();

  /// Returns a body with its complete present state. Call this function again after the body has changed.
  const world::Body& body(std::size_t number) const;
  // Fast access to single values.
  double wheel_angle(std::size_t number, world::Side side) const {
    return blocks_[number / kLanes].angle[side][number % kLanes];
  }
  double wheel_rate(std::size_t number, world::Side side) const {
    const BodyBlock& block = blocks_[number / kLanes];
    return block.surface[side][number % kLanes] * block.per_radius[side][number % kLanes];
  }
  double speed(std::size_t number) const { return blocks_[number / kLanes].v[number % kLanes]; }
  double distance(std::size_t number) const { return blocks_[number / kLanes].distance[number % kLanes]; }
  /// Returns the blocks of kLanes bodies.
  const std::vector<BodyBlock>& blocks() const { return blocks_; }

 private:
  void write(std::size_t number) const;
  void read(std::size_t number);
  void read_figures(std::size_t number, world::Side);
  void step_alone(std::size_t number);

  const world::Walls& walls_;
  std::vector<std::unique_ptr<world::Body>> bodies_;
  std::vector<BodyBlock> blocks_;
};

}  // namespace robosim::batch
