// A robot whose board has a chip of the target: its own board if that will do, else another in its place.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/wire/messages.h"

namespace robosim::launch {

struct FittedRobot {
  std::string robot;  ///< as given, or with another board behind an @ (sim/base/robot_name.h)
  wire::RobotInfo info;
  std::string own_board;  ///< that another took the place of; empty = none did
};

/// `boards` are those that will do; empty = any. The first of them takes the place of one that will not.
/// Throws what `describe` throws, also where the other board lacks a pin that the robot uses.
FittedRobot fit_robot(const std::string& robot, const std::vector<std::string>& boards,
                      const std::function<wire::RobotInfo(const std::string&)>& describe);

}  // namespace robosim::launch
