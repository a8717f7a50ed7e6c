#include "sim/map/cells/cell_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/map/cells/walk.h"

namespace robosim::cells {
namespace cell_robot_test {

using map::Direction;
using ::testing::ElementsAre;

struct OnFloor {
  map::Map map;
  CellFloor floor{map};
  explicit OnFloor(const char* rows) : map(map::parse_map(rows, "drawn.map")) {}
  Sense sense(int x, int y, Direction d) const { return floor.sense(floor.index_of({x, y}), d); }
};

TEST(CellSense, CountsTheFourCells) {
  const OnFloor f(
      "00100\n"
      "11111\n"
      "00100\n"
      "00000\n");
  EXPECT_EQ(f.sense(0, 1, Direction::east), Sense::straight);
  EXPECT_EQ(f.sense(2, 1, Direction::east), Sense::junction);
  EXPECT_EQ(f.sense(4, 1, Direction::west), Sense::straight);
  EXPECT_EQ(f.sense(2, 2, Direction::south), Sense::no_path) << "there is floor ahead";
  EXPECT_EQ(f.sense(4, 1, Direction::east), Sense::no_path) << "the map's edge is a dead end like any other";
  EXPECT_EQ(f.sense(4, 3, Direction::east), Sense::no_path) << "there is no line nearby";
}

TEST(CellSense, KnowsBendsByTheirSide) {
  const OnFloor f(
      "000\n"
      "011\n"
      "010\n");
  EXPECT_EQ(f.sense(1, 1, Direction::north), Sense::right_turn);
  EXPECT_EQ(f.sense(1, 1, Direction::west), Sense::left_turn);
}

TEST(CellSense, LineOnBothSidesOfACellThatIsNoneDependsOnTheDirection) {
  const OnFloor f(
      "010\n"
      "101\n"
      "010\n");
  EXPECT_EQ(f.sense(1, 1, Direction::north), Sense::junction)
      << "there is line in front, to the right and to the left";
  const OnFloor g(
      "000\n"
      "101\n"
      "000\n");
  EXPECT_EQ(g.sense(1, 1, Direction::north), Sense::right_turn);
  EXPECT_EQ(g.sense(1, 1, Direction::south), Sense::left_turn);
}

TEST(CellSense, SeesAWallAtADeadEndAsAWayOnAndOneOnTheLineAsNone) {
  const OnFloor f(
      "00000000\n"
      "11200112\n"
      "00000000\n"
      "11211000\n");
  EXPECT_EQ(f.sense(1, 1, Direction::east), Sense::straight) << "v1 steps into the wall";
  EXPECT_EQ(f.sense(2, 1, Direction::east), Sense::no_path) << "v1 finds no line in the next cell";
  EXPECT_EQ(f.sense(1, 3, Direction::east), Sense::no_path)
      << "the wall is an obstacle, because the line goes on right after it";
}

TEST(CellRobot, StaysWhereItIsAtTheMapsEdgeAndBeforeAnObstacle) {
  const OnFloor f("11x\n");
  CellRobot robot(f.floor, {{1, 0}, Direction::east}, 2.0);
  robot.step_forward();
  EXPECT_EQ(robot.pose(), (CellPose{{1, 0}, Direction::east}));
  robot.turn_left();
  EXPECT_EQ(robot.pose(), (CellPose{{1, 0}, Direction::north}));
  EXPECT_EQ(robot.clock(), 4.0) << "a blocked move takes time, too";
}

TEST(CellRobot, TurnsByMovingToTheSideAndChoosesLineWhereThereIsSome) {
  const OnFloor f(
      "000\n"
      "011\n"
      "000\n");
  CellRobot robot(f.floor, {{1, 1}, Direction::north});
  robot.choose_right();
  EXPECT_EQ(robot.pose(), (CellPose{{2, 1}, Direction::east}));
  robot.choose_right();
  EXPECT_EQ(robot.pose(), (CellPose{{2, 1}, Direction::east}))
      << "no line is to the right, and the map ends ahead";
  robot.turn_around();
  EXPECT_EQ(robot.pose(), (CellPose{{2, 1}, Direction::west}));
  robot.turn_left();
  EXPECT_EQ(robot.pose(), (CellPose{{2, 2}, Direction::south})) << "turns whether or not there is a line";
}

TEST(CellRobot, ThrowsAtTheMoveAfterTheLastOne) {
  const OnFloor f("11111\n");
  CellRobot robot(f.floor, {{0, 0}, Direction::east});
  robot.limit_moves(2);
  robot.step_forward();
  robot.step_forward();
  EXPECT_THROW(robot.step_forward(), OutOfMoves);
  EXPECT_EQ(robot.moves(), 2u);
}

TEST(CellRobot, SlipsAndMissesAsOftenAsItIsToldAndTheSameEachTime) {
  const OnFloor f("11111111\n00000000\n");
  const auto slips = [&](std::uint64_t seed) {
    CellRobot robot(f.floor, {{0, 0}, Direction::east});
    robot.set_noise({0.0, 0.25, seed});
    int count = 0;
    for (int i = 0; i < 4000; ++i) {
      const Direction before = robot.facing();
      robot.turn_around();
      count += robot.facing() == before;
    }
    return count;
  };
  EXPECT_NEAR(slips(1), 1000, 120);
  EXPECT_EQ(slips(1), slips(1));
  EXPECT_NE(slips(1), slips(2));
}

TEST(Walk, OnATreeVisitsEveryDeadEndAndComesHome) {
  const OnFloor f(
      "0000000\n"
      "0001000\n"
      "1111110\n"
      "0100000\n"
      "0000000\n");
  CellRobot left(f.floor, {{0, 2}, Direction::east});
  const Walk l = walk(left, Side::left);
  EXPECT_EQ(l.ending, Walk::Ending::closed);
  EXPECT_THAT(l.dead_ends,
              ElementsAre(map::CellAt{0, 2}, map::CellAt{3, 1}, map::CellAt{5, 2}, map::CellAt{1, 3}));
  CellRobot right(f.floor, {{0, 2}, Direction::east});
  EXPECT_THAT(walk(right, Side::right).dead_ends,
              ElementsAre(map::CellAt{0, 2}, map::CellAt{1, 3}, map::CellAt{5, 2}, map::CellAt{3, 1}));
  EXPECT_EQ(l.end, (CellPose{{0, 2}, Direction::east}));
}

TEST(Walk, EndsBeforeAnObstacleAsAtALinesEnd) {
  const OnFloor f("111x1\n");
  CellRobot robot(f.floor, {{0, 0}, Direction::east});
  const Walk w = walk(robot, Side::left);
  EXPECT_EQ(w.ending, Walk::Ending::closed);
  EXPECT_EQ(w.moves, 2u + 1 + 2 + 1);
}

}  // namespace cell_robot_test
}  // namespace robosim::cells
