// Defines the place and direction of a distance sensor. The sensor is fixed to the body, or to a servo's
// horn.
#pragma once

#include <string>

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

/// The keys `at`, `facing` and `on`. On a servo, they apply to the servo's middle position: `at` is forward
/// and left of the servo's axis, and `facing` is relative to the servo's direction.
struct MountSpec {
  Vec2 at;              ///< m
  double facing = 0.0;  ///< rad, counter-clockwise; 0 = ahead
  std::string servo;    ///< name of the servo; "" = fixed to the body
  Place servo_place;    ///< place of the key `on` in the robot file
};

MountSpec read_mount(PartReader&);

class Mount {
 public:
  Mount(const MountSpec& spec, const View& view);
  /// Looks up the servo.
  void resolve_mounts(const PartRegistry&);

  /// Returns the sensor's maximum distance from the axle's centre, m.
  double arm() const;
  /// Returns the sensor's pose in the world at `t`, a time inside the current tick.
  Pose pose_at(SimTime t) const;

 private:
  const MountSpec& spec_;
  const View& view_;
  const Vec2 direction_;
  const ServoPart* servo_ = nullptr;
};

}  // namespace robosim::robot
