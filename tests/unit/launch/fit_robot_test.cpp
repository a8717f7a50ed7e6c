#include "sim/launch/fit_robot.h"

#include <gtest/gtest.h>

#include "sim/base/robot_name.h"

namespace robosim::launch::fit_robot_test {

/// Returns the description of a robot file with the board uno. In a name such as "my.toml@nano", the board
/// after "@" has priority.
wire::RobotInfo describe(const std::string& robot) {
  const std::string board = parse_robot_name(robot).board;
  wire::RobotInfo info;
  info.name = robot;
  info.board.name = board.empty() ? "uno" : board;
  return info;
}

void expect(const std::string& robot, const std::vector<std::string>& boards, const std::string& fitted,
            const std::string& replaced) {
  const FittedRobot result = fit_robot(robot, boards, describe);
  EXPECT_EQ(result.robot, fitted);
  EXPECT_EQ(result.info.name, fitted) << "the info describes the fitted robot";
  EXPECT_EQ(result.own_board, replaced);
}

TEST(FitRobot, KeepsABoardThatWillDo) {
  expect("my.toml", {}, "my.toml", "");
  expect("my.toml", {"nano", "uno"}, "my.toml", "");
  expect("my.toml@bluepill8", {"bluepill", "bluepill8"}, "my.toml@bluepill8", "");
}

TEST(FitRobot, PutsTheUsualBoardInThePlaceOfAnother) {
  expect("my.toml", {"bluepill", "bluepill8"}, "my.toml@bluepill", "uno");
  expect("my.toml@nano", {"bluepill"}, "my.toml@bluepill", "nano");
}

TEST(FitRobot, GoesBackToTheFilesOwnBoardFirst) {
  expect("my.toml@bluepill8", {"nano", "uno"}, "my.toml", "bluepill8");
}

}  // namespace robosim::launch::fit_robot_test
