// A robot whose board has a chip of the target: its own board if that will do, else another in its place.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/launch/names.h"
#include "sim/wire/messages.h"

namespace robosim::launch {

/// Tells of a robot by its name or path, as a runner does.
using Describe = std::function<wire::RobotInfo(const std::string& robot)>;

struct FittedRobot {
  std::string robot;  ///< as given, or with another board behind an @ (sim/base/robot_name.h)
  wire::RobotInfo info;
  std::string own_board;  ///< that another took the place of; empty = none did
};

/// `boards` are those that will do; empty = any. The first of them takes the place of one that will not.
/// Throws what `describe` throws, also where the other board lacks a pin that the robot uses.
FittedRobot fit_robot(const std::string& robot, const std::vector<std::string>& boards,
                      const Describe& describe);

/// A robot that a sketch for this target can drive, or that its project is for.
struct Carrier {
  Choice robot;
  wire::RobotInfo info;
  std::string announcement;  ///< that another board takes the place of its own; empty = none does
};
/// The robot on the board that its project is for.
Carrier on_its_board(const Choice& robot, const Describe& describe);
/// The same where that has the chip. Throws InputError where no board of the target
/// has all pins that the robot uses.
Carrier fit_to_target(const Choice& robot, const std::string& target, const Describe& describe);

/// The board a robot carries.
const BoardSpec& board_of(const wire::RobotInfo& robot);

}  // namespace robosim::launch
