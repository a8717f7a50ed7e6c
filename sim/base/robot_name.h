// Names of robots: a stock robot's name or the path of a robot file. An optional @ and a board replace the
// robot's own board, as in "uno5@bluepill" or "./my.toml@bluepill8" (docs/reference/robots.md).
#pragma once

#include <string>

namespace robosim {

struct RobotName {
  std::string robot;  ///< the name or path alone
  std::string board;  ///< empty = the board of the robot itself
};

/// Parses a name. An @ introduces a board only if no '/' or '.' follows it, so that folder names may contain
/// one.
RobotName parse_robot_name(const std::string& text);
/// Returns the name of the same robot with that board.
std::string robot_with_board(const std::string& text, const std::string& board);

}  // namespace robosim
