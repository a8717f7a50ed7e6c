#include "sim/base/robot_name.h"

#include <gtest/gtest.h>

namespace robosim::robot_name_test {

void expect(const std::string& text, const std::string& robot, const std::string& board) {
  const RobotName name = parse_robot_name(text);
  EXPECT_EQ(name.robot, robot) << text;
  EXPECT_EQ(name.board, board) << text;
}

TEST(RobotName, NamesABoardBehindAnAt) {
  expect("uno5", "uno5", "");
  expect("uno5@bluepill", "uno5", "bluepill");
  expect("./my.toml@bluepill8", "./my.toml", "bluepill8");
  expect("", "", "");
  expect("./my.toml@", "./my.toml@", "");
}

TEST(RobotName, LeavesAnAtInAPathAlone) {
  expect("/home/me@club/my.toml", "/home/me@club/my.toml", "");
  expect("me@home.toml", "me@home.toml", "");
  expect("/home/me@club/my.toml@nano", "/home/me@club/my.toml", "nano");
}

TEST(RobotName, TakesOneBoardAtATime) {
  EXPECT_EQ(robot_with_board("uno5", "bluepill"), "uno5@bluepill");
  EXPECT_EQ(robot_with_board("uno5@nano", "bluepill"), "uno5@bluepill");
}

}  // namespace robosim::robot_name_test
