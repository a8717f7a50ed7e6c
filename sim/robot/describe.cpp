#include "sim/robot/describe.h"

#include <cmath>
#include <numbers>

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
  for (const auto& part : robot.parts) {
    PartSummary& about = summary.parts.emplace_back(PartSummary{part->name, part->type, {}});
    for (const Wire& wire : part->wires) about.pins.emplace_back(wire.role, wire.pin);
    for (const SensorPlace& sensor : part->sensors()) summary.sensors.push_back(sensor);
    for (const Gauge& gauge : part->gauges()) summary.gauges.push_back(gauge);
  }
  return summary;
}

}  // namespace robosim::robot
