// Parses names of robots: a stock robot's name, or the path of a robot file. An optional suffix, @ and a
// board, replaces the robot's own board: "uno5@bluepill", "./my.toml@bluepill8" (docs/reference/robots.md).
#pragma once

#include <string>

namespace robosim {

struct RobotName {
  std::string robot;  ///< name or path without the board
  std::string board;  ///< empty = the robot's own board
};

/// Parses a name. An @ introduces a board only if no '/' or '.' follows. Names of folders may therefore
/// contain @.
RobotName parse_robot_name(const std::string& text);
/// Returns the name of the robot in `text` with another board.
std::string robot_with_board(const std::string& text, const std::string& board);

}  // namespace robosim
