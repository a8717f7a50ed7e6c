// Derives the parameters of a robot's body from its description (describe.h).
#include <algorithm>
#include <cstring>

#include "sim/base/units.h"
#include "sim/robot/describe.h"
#include "sim/robot/part_context.h"

namespace robosim::robot {
namespace {

// Returns the moment of inertia about the origin, per kilogram (m2), of a uniform plate with the chassis's
// shape.
double plate_inertia(const Chassis& chassis) {
  if (chassis.polygon.empty())
    return 0.5 * chassis.circle_radius * chassis.circle_radius +
           dot(chassis.circle_centre, chassis.circle_centre);
  double area2 = 0.0;
  double moment = 0.0;
  const std::size_t n = chassis.polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = chassis.polygon[i];
    const Vec2 b = chassis.polygon[(i + 1) % n];
    const double c = cross(a, b);
    area2 += c;
    moment += c * (dot(a, a) + dot(a, b) + dot(b, b));
  }
  return moment / (6.0 * area2);
}

// Returns the default x of the caster: three quarters of the way from the axle to the rear. If the chassis
// extends at most 1 cm behind the axle, the front replaces the rear.
double usual_caster(const Chassis& chassis) {
  double rear = chassis.circle_centre.x - chassis.circle_radius,
         front = chassis.circle_centre.x + chassis.circle_radius;
  for (const Vec2 corner : chassis.polygon) {
    rear = std::min(rear, corner.x);
    front = std::max(front, corner.x);
  }
  constexpr double kShare = 0.75, kLeast = 0.01;
  return -rear > kLeast ? kShare * rear : kShare * std::max(front, kLeast);
}

}  // namespace

world::BodyParams body_params(const Description& robot, std::uint64_t seed, Profile profile,
                              std::uint32_t number) {
  const ParameterSampler sampler(seed, profile, number);
  const auto chassis = [&](const Parameter& figure, const char* key) {
    return sampler.draw(figure, "chassis", key);
  };
  const Chassis& c = robot.chassis;
  const Motors& m = robot.motors;
  world::BodyParams params = world::default_body_params();
  const bool differential = std::any_of(robot.parts.begin(), robot.parts.end(),
                                        [](const auto& part) { return part->driven_wheel() == kBothWheels; });
  for (const Side side : {world::left, world::right}) {
    // With a differential, the left motor drives both wheels, so both have the left motor's values.
    const char* name = side == world::left || differential ? "left wheel" : "right wheel";
    const auto each = [&](const Parameter& figure, const char* key) {
      return sampler.draw(figure, name, key);
    };
    world::WheelParams& wheel = params.wheel[side];
    wheel.nominal_volts = sampler.draw(m.voltage, "motors", "voltage");
    wheel.no_load_rate = each(m.no_load, "no_load");
    wheel.no_load_current = each(m.no_load_current, "no_load_current");
    wheel.stall_torque = each(m.stall_torque, "stall_torque");
    wheel.stall_current = each(m.stall_current, "stall_current");
    wheel.static_friction = each(m.static_friction, "static_friction");
    wheel.gear_ratio = sampler.draw(m.gear, "motors", "gear");
    wheel.rotor_inertia_kgm2 = sampler.draw(m.rotor_inertia, "motors", "rotor_inertia");
    wheel.inductance_h = each(m.inductance, "inductance");
    if (differential) {
      wheel.no_load_current *= 0.5;
      wheel.stall_torque *= 0.5;
      wheel.stall_current *= 0.5;
      wheel.rotor_inertia_kgm2 *= 0.5;
      wheel.inductance_h *= 2.0;
    }
    wheel.wheel_inertia_kgm2 = chassis(c.wheel_inertia, "wheel_inertia");
    wheel.radius_m = 0.5 * sampler.draw(c.wheel, side == world::left ? "left wheel" : "right wheel", "wheel");
  }
  params.supply_volts = sampler.draw(m.supply, "motors", "supply");
  params.driver_drop_volts = sampler.draw(robot.driver.drop, "driver", "drop");
  params.driver_ohms = sampler.draw(robot.driver.resistance, "driver", "resistance");
  params.driver_diode_volts = sampler.draw(robot.driver.diode, "driver", "diode");
  params.driver_both_ways = robot.driver.chip->both_ways;
  params.driver_single = std::strcmp(robot.driver.chip->name, "transistor") == 0;
  params.track_m = chassis(c.track, "track");
  params.mass_kg = chassis(c.mass, "mass");
  params.yaw_inertia_kgm2 =
      c.inertia.value > 0.0 ? chassis(c.inertia, "inertia") : params.mass_kg * plate_inertia(c);
  params.load_share = chassis(c.load_share, "load_share");
  params.rolling_resistance = chassis(c.rolling, "rolling");
  params.grip = chassis(c.grip, "grip");
  params.wall_friction = chassis(c.wall_friction, "wall_friction");
  params.caster_m = c.caster.value != 0.0 ? chassis(c.caster, "caster") : usual_caster(c);
  params.caster_radius_m = chassis(c.caster_radius, "caster_radius");
  params.centre_height_m = chassis(c.height, "height");
  params.wheelbase_m = chassis(c.wheelbase, "wheelbase");
  if (c.steering.exists()) {
    params.steer_base_m = params.caster_m = chassis(c.steering.base, "steering.base");
    params.caster_radius_m = params.wheel[world::left].radius_m;
    params.differential = differential;
  }
  params.downforce_n = kGravity * chassis(c.downforce, "downforce");
  params.outline = c.polygon;
  params.radius_m = c.circle_radius;
  params.centre = c.circle_centre;
  return params;
}

}  // namespace robosim::robot
