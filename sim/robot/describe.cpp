#include "sim/robot/describe.h"

#include <cmath>
#include <numbers>

#include "sim/robot/parts/servo.h"

namespace robosim::robot {
namespace {

constexpr int kCircleCorners = 24;

std::vector<Vec2> outline_of(const Chassis& chassis) {
  if (!chassis.polygon.empty()) return chassis.polygon;
  std::vector<Vec2> corners;
  for (int i = 0; i < kCircleCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCircleCorners;
    corners.push_back(chassis.circle_centre + chassis.circle_radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return corners;
}

std::optional<SteeredWheels> steered_of(const Description& robot) {
  const Steering& steering = robot.chassis.steering;
  if (!steering.exists()) return std::nullopt;
  SteeredWheels wheels;
  wheels.servo = steering.servo;
  wheels.base = steering.base.value;
  wheels.wheels = steering.ackermann ? 2 : 1;
  wheels.limit = steering.ackermann
                     ? world::steered_middle(steering.limit.value, robot.chassis.track.value, wheels.base)
                     : steering.limit.value;
  for (const auto& part : robot.parts) {
    const auto* servo = dynamic_cast<const ServoSpec*>(part.get());
    if (!servo || servo->name != steering.servo) continue;
    wheels.middle = servo->range.value / 2.0;
    wheels.ratio = servo->reversed ? -steering.ratio.value : steering.ratio.value;
  }
  return wheels;
}

}  // namespace

Summary describe(const Description& robot) {
  Summary summary;
  summary.name = robot.name;
  summary.file = robot.file.string();
  summary.sha256 = robot.sha256;
  summary.board = robot.board;
  summary.registers = robot.registers;
  summary.budget = robot.budget;
  summary.outline = outline_of(robot.chassis);
  summary.track = robot.chassis.track.value;
  summary.wheel = robot.chassis.wheel.value;
  summary.steered = steered_of(robot);
  for (const auto& part : robot.parts) {
    PartSummary& about = summary.parts.emplace_back(PartSummary{part->name, part->type, {}});
    for (const Wire& wire : part->wires) about.pins.emplace_back(wire.role, wire.pin);
    for (const SensorPlace& sensor : part->sensors()) summary.sensors.push_back(sensor);
    for (const Gauge& gauge : part->gauges()) summary.gauges.push_back(gauge);
  }
  return summary;
}

}  // namespace robosim::robot
