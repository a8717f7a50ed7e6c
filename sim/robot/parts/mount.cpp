#include "sim/robot/parts/mount.h"

#include <algorithm>
#include <limits>

#include "sim/base/trig_series.h"
#include "sim/robot/parts/servo.h"

namespace robosim::robot {

MountSpec read_mount(PartReader& reader) {
  MountSpec spec;
  spec.at = reader.point("at", {});
  spec.facing = reader.angle("facing");
  if (const ConfigValue* on = reader.table().find("on")) {
    spec.servo = as_string(*on, "on");
    spec.servo_place = on->place;
  }
  return spec;
}

Mount::Mount(const MountSpec& spec, const View& view)
    : spec_(spec), view_(view), direction_(direction_of(spec.facing)) {}

void Mount::resolve_mounts(const PartRegistry& registry) {
  for (const ServoPart* servo : registry.servos)
    if (servo->name() == spec_.servo) servo_ = servo;
}

double Mount::arm() const { return length(spec_.at) + (servo_ ? servo_->arm() : 0.0); }

double PartRegistry::sight() const {
  if (has_radio || !fans.empty()) return std::numeric_limits<double>::infinity();
  double sight = 0.0;
  for (const Sightline& lookout : sightlines) sight = std::max(sight, lookout.mount->arm() + lookout.reach);
  return sight;
}

Pose Mount::pose_at(SimTime t) const {
  Pose on_body{spec_.at, direction_};
  if (servo_) {
    const Pose horn = servo_->horn(t);
    on_body = {horn.to_world(spec_.at), horn.heading * direction_.x + left_of(horn.heading) * direction_.y};
  }
  const Pose body = view_.pose_at(t);
  return {body.to_world(on_body.position),
          body.heading * on_body.heading.x + left_of(body.heading) * on_body.heading.y};
}

}  // namespace robosim::robot
