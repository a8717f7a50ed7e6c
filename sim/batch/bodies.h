// Many bodies, each as if it were alone on one floor: for searches that drive a body again and again with
// other figures or other commands.
//
// A tick of a body that rolls (sim/world/body.h) is some hundred additions and multiplications, each of which
// waits for the one before. Here they are done for a block of bodies at once (lanes.h), in the same order,
// and so with the same bits. This holds for what bodies do nearly always: both tyres roll, both wheels turn
// the way they turned, nothing is near. Each tick each lane is tested for that. One that starts, stops,
// slips, skids, or comes near a wall, and any body that is not an ordinary one (windings, steered wheels,
// wheels that skid, loads that shift), goes through this tick as a world::Body, by Body's own code. The
// tick of one that rolls is rolling.h's, which single bodies take, too; batch_test.cpp compares them, bit by
// bit.
//
// Bodies of a batch neither see nor touch each other.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/batch/lanes.h"
#include "sim/world/body.h"
#include "sim/world/world.h"

namespace robosim::batch {

/// What a block's bodies do: their Rolling (sim/world/rolling.h), by the names there.
struct BodyMotion {
  Lanes x, y, heading_x, heading_y;  // m; unit vector
  Lanes v, u, omega;                 // m/s, m/s, rad/s
  Lanes surface[2], angle[2];        // m/s, rad
  Lanes wheel_travel, distance;      // m
  Lanes energy;                      // J
  Lanes free_way;                    // m
  Lanes slips;                       // 1 = yes

  /// One body's.
  void take(const BodyMotion&, std::size_t lane);
};

/// And what they are: their Roller.
struct BodyBlock : BodyMotion {
  // Of the commands as they are.
  Lanes direction[2], drives[2];          // the sign of `drive`, its amount
  Lanes push[2], drag[2], push_until[2];  // driven
  Lanes brake_push[2], brake_drag[2], brake_from[2];
  // Of the bodies.
  Lanes per_radius[2], inertia[2], turning_friction[2], joule0[2], joule1[2], side_share[2];
  Lanes owns[2], grip_squares[2], skids_from;
  Lanes mass, mass_own, mass_cross, half_track, per_track, bound_radius, way_per_travel, stride;
  Lanes rolls;  // 1 = an ordinary body that touches nothing
};

class Bodies {
 public:
  /// The world is not changed, and must outlive this. Throws std::invalid_argument where its floor is not a
  /// plane of one kind.
  explicit Bodies(const world::World& world);

  /// Bodies are numbered from 0. Throws std::invalid_argument (see world::Body).
  std::size_t add(const world::BodyParams&, const Pose&);
  std::size_t size() const { return bodies_.size(); }

  /// As world::Body has it.
  void command(std::size_t number, world::Side, const world::WheelCommand&);
  void place(std::size_t number, const Pose&);

  /// One tick of all.
  void step();

  /// All about one of them, until it changes again.
  const world::Body& body(std::size_t number) const;
  // What is asked of many.
  double wheel_angle(std::size_t number, world::Side side) const {
    return blocks_[number / kLanes].angle[side][number % kLanes];
  }
  double wheel_rate(std::size_t number, world::Side side) const {
    const BodyBlock& block = blocks_[number / kLanes];
    return block.surface[side][number % kLanes] * block.per_radius[side][number % kLanes];
  }
  double speed(std::size_t number) const { return blocks_[number / kLanes].v[number % kLanes]; }
  double distance(std::size_t number) const { return blocks_[number / kLanes].distance[number % kLanes]; }
  /// In steps of kLanes.
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
