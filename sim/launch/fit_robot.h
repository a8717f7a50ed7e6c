// Selects a robot's board so that its chip suits the target. The robot keeps its own board if possible, and
// otherwise gets another board.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/launch/names.h"
#include "sim/wire/messages.h"

namespace robosim::launch {

/// Describes a robot by its name or path, as a runner does.
using Describe = std::function<wire::RobotInfo(const std::string& robot)>;

struct FittedRobot {
  std::string robot;  ///< as given, or with another board after an @ (sim/base/robot_name.h)
  wire::RobotInfo info;
  std::string own_board;  ///< the board that was replaced; empty = no board was replaced
};

/// Returns the robot with one of `boards`; an empty list allows any board. The first of `boards` replaces an
/// unsuitable board. Throws the exceptions of `describe`, which also throws if the replacement lacks a pin of
/// the robot.
FittedRobot fit_robot(const std::string& robot, const std::vector<std::string>& boards,
                      const Describe& describe);

/// A robot whose board suits the target or the project of a sketch.
struct Carrier {
  Choice robot;
  wire::RobotInfo info;
  std::string announcement;  ///< sentence about a replaced board; empty = not replaced
};
/// Returns the robot on the board that the sketch's project specifies.
Carrier on_its_board(const Choice& robot, const Describe& describe);
/// Returns the robot on a board that has a chip of the target. Prefers the board of the sketch's project,
/// then the robot's own board, then any other board. Throws InputError if no board of the target has all pins
/// that the robot uses.
Carrier fit_to_target(const Choice& robot, const std::string& target, const Describe& describe);

/// Returns a robot's board.
const BoardSpec& board_of(const wire::RobotInfo& robot);

}  // namespace robosim::launch
