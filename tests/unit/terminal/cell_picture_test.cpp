#include "sim/view/terminal/cell_picture.h"

#include <gtest/gtest.h>

#include "tests/unit/terminal/terminal_looks.h"

namespace robosim::terminal {
namespace cell_picture_test {

std::string drawn(const std::string& map_text, int columns, int rows, const map::Start& robot,
                  std::vector<CellLabel> labels = {}, Look look = kAscii) {
  const map::Map map = map::parse_map(map_text, "test.map");
  CellPicture picture(map);
  Frame frame(columns, rows);
  picture.draw(frame, 0, rows, robot.cell, robot, labels, look);
  return to_text(frame, look);
}

constexpr const char* kTee = "_____\n_..._\n__._#\n";

TEST(CellPicture, DrawsLineRobotAndWallsAsLargeAsFits) {
  EXPECT_EQ(drawn(kTee, 10, 3, {{1, 1}, map::Direction::east}), "\n  >-+--\n    |   ##\n");
  EXPECT_EQ(drawn(kTee, 5, 3, {{1, 1}, map::Direction::east}), "\n >+-\n  | #\n");
  EXPECT_EQ(drawn(kTee, 20, 6, {{1, 1}, map::Direction::east}),
            "\n\n    >---+----\n        |\n        |       ####\n                ####\n");
}

TEST(CellPicture, LabelsEndOnACellWhoseLineComesFromTheRightAndStandBesideTheRobot) {
  const std::vector<CellLabel> labels{{{1, 1}, "S1"}, {{2, 1}, "J1"}, {{3, 1}, "S2"}};
  EXPECT_EQ(drawn(kTee, 10, 3, {{2, 2}, map::Direction::north}, labels), "\n S1-J1S2\n    ^   ##\n");
  EXPECT_EQ(drawn(kTee, 10, 3, {{1, 1}, map::Direction::south}, labels), "\nS1v-J1S2\n    |   ##\n");
}

TEST(CellPicture, ShowsAPartAroundTheRobotAndSaysWhich) {
  std::string map;
  for (int y = 0; y < 60; ++y) map += y == 30 ? std::string(100, '1') + "\n" : std::string(100, '0') + "\n";
  const std::string text = drawn(map, 50, 10, {{50, 30}, map::Direction::west});
  EXPECT_NE(text.find('<'), std::string::npos);
  EXPECT_NE(text.find("columns 38 to 62 of 100, rows 29 to 31 of 60"), std::string::npos) << text;
}

TEST(CellPicture, ARobotFarFromTheLineIsInSightToo) {
  std::string map;
  for (int y = 0; y < 60; ++y) map += y == 30 ? std::string(100, '1') + "\n" : std::string(100, '0') + "\n";
  for (const map::CellAt cell : {map::CellAt{0, 0}, {99, 59}, {99, 0}, {0, 59}})
    EXPECT_NE(drawn(map, 30, 8, {cell, map::Direction::north}).find('^'), std::string::npos);
}

TEST(CellPicture, IsPlainAsciiWhereTheTerminalCanDoNoMore) {
  for (const char c : drawn(kTee, 20, 6, {{1, 1}, map::Direction::east})) EXPECT_LT(c & 0xFF, 0x80);
}

TEST(CellPicture, TheTrailIsInAnotherInk) {
  const map::Map map = map::parse_map(kTee, "test.map");
  CellPicture picture(map);
  picture.add_trail({1, 1});
  picture.add_trail({2, 1});
  picture.add_trail({-1, 5});  // outside of the map: draws nothing
  Frame frame(10, 3);
  picture.draw(frame, 0, 3, {1, 1}, std::nullopt, {}, kAscii);
  EXPECT_EQ(frame.at(3, 1).ink, Ink::trail);
  EXPECT_EQ(frame.at(5, 1).ink, Ink::line);
}

}  // namespace cell_picture_test
}  // namespace robosim::terminal
