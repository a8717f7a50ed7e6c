// The place and direction of a sensor that looks along the floor, fixed to the body or on a servo's horn.
#pragma once

#include <string>

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

/// The keys `at`, `facing` and `on`. On a servo, place and direction apply to its middle position: `at`
/// forward and left of its axis, `facing` relative to its own.
struct MountSpec {
  Vec2 at;              ///< m
  double facing = 0.0;  ///< rad: 0 ahead, counter-clockwise
  std::string servo;    ///< its name; "" = fixed to the body
  Place servo_place;    ///< in the file
};

MountSpec read_mount(PartReader&);

class Mount {
 public:
  Mount(const MountSpec& spec, const View& view);
  /// Looks up its servo.
  void resolve_mounts(const PartRegistry&);

  /// Returns the maximum distance from the axle's centre, m.
  double arm() const;
  /// Returns its pose in the world, at `t`, a time inside the current tick.
  Pose pose_at(SimTime t) const;

 private:
  const MountSpec& spec_;
  const View& view_;
  const Vec2 direction_;
  const ServoPart* servo_ = nullptr;
};

}  // namespace robosim::robot
