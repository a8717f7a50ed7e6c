#include "sim/view/terminal/floor_picture.h"

#include <gtest/gtest.h>

#include "tests/unit/terminal/terminal_looks.h"

namespace robosim::terminal {
namespace floor_picture_test {

std::string drawn(const FloorPicture& floor, const std::vector<Mark>& marks, Look look) {
  Frame frame(floor.window().columns, floor.window().rows);
  floor.draw(frame, 0, 0, marks, look);
  return to_text(frame, look);
}

// The map has a line from left to right below a wall. One cell is 4 x 2 characters.
class FloorPictureTest : public ::testing::Test {
 protected:
  FloorPictureTest() : map_(map::parse_map("222\n111\n", "t.map")), floor_(map_) {
    floor_.look_at(fit(map_, area_of(map_), 12, 100));
  }
  map::Map map_;
  FloorPicture floor_;
};

TEST_F(FloorPictureTest, WallAndLineLookDifferent) {
  EXPECT_EQ(drawn(floor_, {}, kPlain),
            "░░░░░░░░░░░░\n"
            "░░░░░░░░░░░░\n"
            "\n"
            "  ········\n");
  EXPECT_EQ(drawn(floor_, {}, kAscii),
            "############\n"
            "############\n"
            "\n"
            "  ........\n");
}

TEST_F(FloorPictureTest, TheTrailLiesOnTheLineAndIsForgottenWithTheWindow) {
  // In the world, y increases to the north. The line's centre is at y = 50 mm.
  floor_.add_trail({0.05, 0.055}, {0.15, 0.055});
  EXPECT_EQ(drawn(floor_, {}, kPlain),
            "░░░░░░░░░░░░\n"
            "░░░░░░░░░░░░\n"
            "  ⣀⣀⣀⣀⡀\n"
            "  ········\n");
  EXPECT_EQ(drawn(floor_, {}, kAscii),
            "############\n"
            "############\n"
            "  *****\n"
            "  ........\n");
  floor_.look_at(floor_.window());
  EXPECT_EQ(drawn(floor_, {}, kAscii).find('*'), std::string::npos);
}

TEST_F(FloorPictureTest, TheRobotLiesOnTheTrailAndMarksOnEverything) {
  floor_.add_trail({0.0, 0.055}, {0.3, 0.055});
  floor_.set_robot({{0.1, 0.03}, {0.2, 0.03}, {0.2, 0.07}, {0.1, 0.07}}, {0.15, 0.05}, {0.2, 0.05});
  Frame frame(12, 4);
  floor_.draw(frame, 0, 0, {{{0.15, 0.05}, {U'→', Ink::robot}}}, kColour);
  EXPECT_EQ(frame.at(0, 2).ink, Ink::trail);
  EXPECT_EQ(frame.at(4, 2).ink, Ink::robot);
  EXPECT_EQ(frame.at(7, 3).ink, Ink::robot);
  EXPECT_EQ(frame.at(6, 3).c, U'→');
}

TEST_F(FloorPictureTest, WhatIsOutsideTheWindowIsNotDrawn) {
  floor_.add_trail({-1e9, 0.05}, {-1.0, 0.05});
  EXPECT_EQ(drawn(floor_, {{{5.0, 5.0}, {U'X', Ink::mark}}}, kAscii).find_first_of("*X"), std::string::npos);
}

TEST(FloorPicture, ShowsWhereTheFloorIsOfAnotherKind) {
  const map::Map map = map::parse_map(
      "+++\n[legend]\n3 = \"wet\"\n4 = \"wet line\"\n[[surface]]\nat = [\"350 mm\", \"150 mm\"]\n"
      "size = [\"100 mm\", \"100 mm\"]\nkind = \"carpet\"\n+++\n_3__\n.44.\n",
      "t.map");
  FloorPicture floor(map);
  floor.look_at(fit(map, area_of(map), 16, 100));
  EXPECT_EQ(drawn(floor, {}, kAscii),
            "    ~ ~     ~ ~\n"
            "     ~ ~     ~ ~\n"
            "    ~ ~ ~ ~\n"
            "  ............\n");
}

TEST(FloorPicture, AHillSaysWhereItIsUpAndTheLineLiesOnIt) {
  const map::Map map = map::parse_map(
      "+++\n[[hill]]\nat = [\"100 mm\", \"100 mm\"]\nsize = [\"200 mm\", \"200 mm\"]\nslope = \"10 deg\"\n"
      "[[hill]]\nat = [\"250 mm\", \"100 mm\"]\nsize = [\"100 mm\", \"200 mm\"]\n"
      "heights = [\"34 mm\", \"34 mm\"]\n+++\n____\n1111\n",
      "t.map");
  FloorPicture floor(map);
  floor.look_at(fit(map, area_of(map), 16, 100));
  EXPECT_EQ(drawn(floor, {}, kAscii),
            "> > > > : :\n"
            " > > > > : :\n"
            "> > > > : :\n"
            " >............\n");
}

TEST(FloorPicture, AGapIsNotPainted) {
  const auto map = map::parse_map("+++\n[legend]\n3 = \"gap\"\n+++\n11311\n", "t.map");
  FloorPicture floor(map);
  floor.look_at(fit(map, area_of(map), 20, 100));
  EXPECT_EQ(drawn(floor, {}, kPlain), "\n  ······    ······\n");
}

TEST(Window, AMapThatFitsGetsAWholeNumberOfDotsACell) {
  const auto map = map::parse_map("11111\n1___1\n11111\n", "t.map");
  const Window window = fit(map, area_of(map), 78, 5);
  EXPECT_DOUBLE_EQ(window.dot_m, 0.1 / 6);  // 5 rows have 20 dots for 3 cells
  EXPECT_EQ(window.columns, 15);
  EXPECT_EQ(window.rows, 5);
}

TEST(Window, ACellGetsSixteenDotsAtMost) {
  const auto map = map::parse_map("11\n", "t.map");
  const Window window = fit(map, area_of(map), 500, 500);
  EXPECT_EQ(window.columns, 16);
  EXPECT_EQ(window.rows, 4);
}

TEST(Arrow, PointsWhereTheRobotFaces) {
  EXPECT_EQ(arrow(0.0), U'→');
  EXPECT_EQ(arrow(1.57), U'↑');
  EXPECT_EQ(arrow(-1.57), U'↓');
  EXPECT_EQ(arrow(3.14), U'←');
  EXPECT_EQ(arrow(-3.14), U'←');
  EXPECT_EQ(arrow(0.79), U'↗');
}

}  // namespace floor_picture_test
}  // namespace robosim::terminal
