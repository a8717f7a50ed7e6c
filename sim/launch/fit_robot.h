// Finds a robot whose board has a chip of the target: with its own board if possible, else with another one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/launch/names.h"
#include "sim/wire/messages.h"

namespace robosim::launch {

/// Describes a robot by its name or path, like a runner.
using Describe = std::function<wire::RobotInfo(const std::string& robot)>;

struct FittedRobot {
  std::string robot;  ///< as given, or with another board after an @ (sim/base/robot_name.h)
  wire::RobotInfo info;
  std::string own_board;  ///< the board that was replaced; empty = none was
};

/// Fits the robot to `boards`; empty = any board. The first of them replaces an unsuitable one. Throws the
/// exceptions of `describe`, also if the other board lacks a pin that the robot uses.
FittedRobot fit_robot(const std::string& robot, const std::vector<std::string>& boards,
                      const Describe& describe);

/// A robot that a sketch for this target can drive, or that its project is for.
struct Carrier {
  Choice robot;
  wire::RobotInfo info;
  std::string announcement;  ///< reports that another board replaces its own; empty = none does
};
/// Returns the robot on the board that its project is for.
Carrier on_its_board(const Choice& robot, const Describe& describe);
/// Returns it on that board if it has the chip, else on another one. Throws InputError if no board of the
/// target has all pins that the robot uses.
Carrier fit_to_target(const Choice& robot, const std::string& target, const Describe& describe);

/// Returns a robot's board.
const BoardSpec& board_of(const wire::RobotInfo& robot);

}  // namespace robosim::launch
