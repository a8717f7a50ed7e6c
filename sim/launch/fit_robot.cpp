#include "sim/launch/fit_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/robot_name.h"
#include "sim/build/sketch.h"
#include "sim/wire/protocol.h"

namespace robosim::launch {

FittedRobot fit_robot(const std::string& robot, const std::vector<std::string>& boards,
                      const Describe& describe) {
  const auto will_do = [&](const wire::RobotInfo& info) {
    return boards.empty() || std::find(boards.begin(), boards.end(), info.board.name) != boards.end();
  };
  FittedRobot fitted{robot, describe(robot), ""};
  if (will_do(fitted.info)) return fitted;
  fitted.own_board = fitted.info.board.name;
  const RobotName name = parse_robot_name(robot);
  if (!name.board.empty()) {
    fitted = {name.robot, describe(name.robot), fitted.own_board};
    if (will_do(fitted.info)) return fitted;
  }
  fitted.robot = robot_with_board(robot, boards.front());
  fitted.info = describe(fitted.robot);
  return fitted;
}

const BoardSpec& board_of(const wire::RobotInfo& robot) {
  const BoardSpec* board = find_board(robot.board.name.c_str());
  if (!board)
    throw wire::RunnerError("the runner named a board that this program does not have: " + robot.board.name);
  return *board;
}

Carrier on_its_board(const Choice& robot, const Describe& describe) {
  Carrier carrier{robot, describe(robot.path.string()), ""};
  if (!robot.board || carrier.info.board.name == robot.board->name) return carrier;
  carrier.robot.name = robot_with_board(robot.name, robot.board->name);
  carrier.robot.path = robot_with_board(robot.path.string(), robot.board->name);
  carrier.info = describe(carrier.robot.path.string());
  carrier.announcement = fmt::format("the robot is {}: {}", carrier.robot.name, robot.board_said);
  return carrier;
}

Carrier fit_to_target(const Choice& own, const std::string& target, const Describe& describe) {
  const std::vector<std::string> boards = build::boards_of(target);
  const bool serves = own.board && (boards.empty() ||
                                    std::find(boards.begin(), boards.end(), own.board->name) != boards.end());
  const Carrier wanted = serves ? on_its_board(own, describe) : Carrier{own, {}, ""};
  const Choice& robot = wanted.robot;
  FittedRobot fitted = fit_robot(robot.path.string(), boards, describe);
  Carrier carrier{robot, std::move(fitted.info), wanted.announcement};
  if (fitted.own_board.empty()) return carrier;
  const std::string& board = carrier.info.board.name;
  carrier.robot.path = fitted.robot;
  carrier.robot.name = parse_robot_name(fitted.robot).board.empty() ? parse_robot_name(robot.name).robot
                                                                    : robot_with_board(robot.name, board);
  // Shows the name that the user has typed. For a file, this is the path without a board.
  const std::string alone = parse_robot_name(robot.name).robot;
  carrier.announcement =
      alone.find('.') == alone.npos
          ? fmt::format("for target {0}, the robot is {1}: a {3} replaces its {2} on the same pins", target,
                        carrier.robot.name, fitted.own_board, board)
          : fmt::format("for target {}, a {} replaces the board {} of {} on the same pins", target, board,
                        fitted.own_board, alone);
  return carrier;
}

}  // namespace robosim::launch
