// How people and programs name a robot: a stock robot's name or the path of a robot file, and after an @ the
// board that replaces its own, as in "uno5@bluepill" or "./my.toml@bluepill8" (docs/robots.md).
#pragma once

#include <string>

namespace robosim {

struct RobotName {
  std::string robot;  ///< the name or path alone
  std::string board;  ///< empty = the robot's own
};

/// An @ introduces a board only if no '/' or '.' follows it, so that names of folders may contain one.
RobotName parse_robot_name(const std::string& text);
/// The same robot with that board.
std::string robot_with_board(const std::string& text, const std::string& board);

}  // namespace robosim
