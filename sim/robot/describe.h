// Summarises a robot's description for clients (describe_robot in docs/reference/runner-protocol.md), and
// derives the parameters of its body in the simulated world.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/robot/description.h"
#include "sim/robot/netlist.h"
#include "sim/robot/robot.h"
#include "sim/world/body.h"

namespace robosim::robot {

struct PartSummary {
  std::string name;
  std::string type;
  std::vector<std::pair<std::string, Pin>> pins;  ///< role and wire (netlist.h)
};

/// Wheels that a servo steers, for drawing.
struct SteeredWheels {
  std::string servo;    ///< name of the steering servo
  double base = 0.0;    ///< m, distance from the driven axle
  int wheels = 1;       ///< 1, or 2 that are Summary::track apart
  double middle = 0.0;  ///< rad, the servo's reading when the wheels point ahead
  double ratio = 0.0;   ///< rad of steering to the left per rad of the reading
  double limit = 0.0;   ///< rad, largest steering angle to each side
};

struct Summary {
  std::string name;
  std::string file;
  std::string sha256;
  const BoardSpec* board = nullptr;
  Budget budget;
  std::vector<Vec2> outline;         ///< m; a circle as 24 corners
  double track = 0.0;                ///< m, between the wheels' contact points
  double wheel = 0.0;                ///< m, a wheel's diameter
  std::vector<SensorPlace> sensors;  ///< in the order of Robot::readings()
  std::vector<Gauge> gauges;         ///< readings that are numbers with units
  std::vector<PartSummary> parts;
  std::optional<SteeredWheels> steered;
  std::vector<Register> registers;  ///< of shift registers and PWM drivers, by register number (netlist.h)
};

Summary describe(const Description&);

/// Returns the body parameters of one robot. Samples them from (seed, number), except in the profile `ideal`.
world::BodyParams body_params(const Description&, std::uint64_t seed, Profile, std::uint32_t number = 0);

}  // namespace robosim::robot
