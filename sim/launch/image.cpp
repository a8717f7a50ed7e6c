#include "sim/launch/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "sim/base/file.h"
#include "sim/base/robot_name.h"
#include "sim/client/runner.h"
#include "sim/launch/fit_robot.h"

namespace robosim::launch {

const BoardSpec& board_of(const wire::RobotInfo& robot) {
  const BoardSpec* board = find_board(robot.board.name.c_str());
  if (!board)
    throw wire::RunnerError("the runner named a board that this program lacks: " + robot.board.name);
  return *board;
}

std::string chip_target_of(const BoardSpec& board) {
  for (const std::string& target : build::targets()) {
    const std::vector<std::string> boards = build::boards_of(target);
    if (std::find(boards.begin(), boards.end(), board.name) != boards.end()) return target;
  }
  return "";
}

Carrier fit_to_target(const Choice& robot, const std::string& target,
                      const std::function<wire::RobotInfo(const std::string&)>& describe) {
  FittedRobot fitted = fit_robot(robot.path.string(), build::boards_of(target), describe);
  Carrier carrier{robot, std::move(fitted.info), ""};
  if (fitted.own_board.empty()) return carrier;
  const std::string& board = carrier.info.board.name;
  carrier.robot.path = fitted.robot;
  carrier.robot.name = parse_robot_name(fitted.robot).board.empty() ? parse_robot_name(robot.name).robot
                                                                    : robot_with_board(robot.name, board);
  carrier.announcement = fmt::format(
      "on {} the robot is {}: its {} has no such chip, and a {} takes its place, on the same pins", target,
      carrier.robot.name, fitted.own_board, board);
  return carrier;
}

build::Image image_of(const SketchChoice& sketch, const build::Request& request, Progress& progress,
                      bool warnings) {
  if (!sketch.elf_target.empty()) {
    build::Image image;
    image.name = sketch.name;
    image.image = sketch.path;
    image.sketch_sha256 = sha256_of_file(sketch.path);
    return image;
  }
  progress.say("compiling " + sketch.name + " …");
  build::Image image = build::build(request);
  progress.clear();
  if (warnings && !image.messages.empty()) fmt::print(stderr, "{}", image.messages);
  return image;
}

}  // namespace robosim::launch
