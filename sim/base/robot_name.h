// What people and programs call a robot: a stock robot's name or the path of a robot file, and behind an @
// the board that takes the place of its own, as in "uno5@bluepill" or "./my.toml@bluepill8" (docs/robots.md).
#pragma once

#include <string>

namespace robosim {

struct RobotName {
  std::string robot;  ///< the name or path alone
  std::string board;  ///< empty = the robot's own
};

/// An @ counts as the board's if nothing with a '/' or '.' comes behind it, so that folders may have one.
RobotName parse_robot_name(const std::string& text);
/// The same robot with that board.
std::string robot_with_board(const std::string& text, const std::string& board);

}  // namespace robosim
