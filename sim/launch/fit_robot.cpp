#include "sim/launch/fit_robot.h"

#include <algorithm>

#include "sim/base/robot_name.h"

namespace robosim::launch {

FittedRobot fit_robot(const std::string& robot, const std::vector<std::string>& boards,
                      const std::function<wire::RobotInfo(const std::string&)>& describe) {
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

}  // namespace robosim::launch
