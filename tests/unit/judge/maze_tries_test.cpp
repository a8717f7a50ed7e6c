#include "sim/judge/maze_tries.h"

#include <gmock/gmock.h>

#include "tests/unit/judge/hand_moved.h"

namespace robosim::judge::maze_tries_test {

using ::testing::HasSubstr;

constexpr const char* kMaze = R"(+++
goal = "line-maze:2"
[[area]]
colour = "black"
at = ["1050 mm", "150 mm"]
radius = "50 mm"
+++
_____________
_S11111111G__
_____________
)";

struct Maze : HandMoved {
  explicit Maze(const std::string& text = kMaze) : HandMoved(text) {}
  void put(double x) { HandMoved::put({x, 0.15}); }
  // Moves the robot along the line at 0.5 m/s.
  void push(double to) { HandMoved::push({to, 0.15}, 5e-4); }
};

TEST(LineMaze, TheBetterOfTwoTriesCountsAndStoppingOnTheDiscTakesTenSecondsOff) {
  Maze maze;
  maze.wait(3 * kSecond);
  EXPECT_EQ(maze.summary(), "0 of 2 tries made, the disc was not reached");
  maze.push(1.1);  // moves over the goal's disc, which ends at 1.1 m
  EXPECT_EQ(maze.summary(), "0 of 2 tries made, the disc is touched");
  EXPECT_TRUE(std::isnan(maze.score().score));
  EXPECT_EQ(maze.score().score_unit, "s");
  maze.push(1.25);
  // The robot drives from x = 0.16 m to x = 0.94 m at 0.5 m/s, which takes 1.56 s.
  EXPECT_NEAR(maze.score().score, 1.56, 0.01);
  EXPECT_FALSE(maze.progress.reached());
  EXPECT_THAT(maze.progress.summary(), HasSubstr("1 of 2 tries made, the disc was reached after 1.5"));
  maze.put(0.15);
  maze.wait(5 * kSecond);
  maze.push(1.0);
  EXPECT_FALSE(maze.progress.reached());
  maze.wait(1100 * kMillisecond);
  EXPECT_TRUE(maze.progress.reached());
  EXPECT_NEAR(maze.score().score, -8.44, 0.01);
  EXPECT_NEAR(maze.score().run_s, 1.56, 0.01);
  EXPECT_EQ(maze.score().score_parts.size(), 3u);
  EXPECT_THAT(maze.progress.summary(), HasSubstr("10 s off for stopping on it"));
  EXPECT_EQ(std::count_if(maze.events.begin(), maze.events.end(),
                          [](const auto& e) { return std::holds_alternative<result::Scored>(e); }),
            2);
}

TEST(LineMaze, ATryThatAHandEndsIsLost) {
  Maze maze;
  maze.push(0.6);
  maze.put(0.9);  // moves the robot manually to the disc
  maze.push(1.0);
  maze.wait(2 * kSecond);
  EXPECT_TRUE(std::isnan(maze.score().score));
  maze.put(0.15);
  maze.push(1.0);
  maze.wait(2 * kSecond);
  EXPECT_TRUE(maze.progress.reached());
  maze.put(0.15);  // there is no third try
  maze.push(1.0);
  maze.wait(2 * kSecond);
  EXPECT_EQ(maze.score().score_parts.size(), 2u);
}

TEST(LineMaze, NeedsAnEndAndADiscThere) {
  std::string text = kMaze;
  EXPECT_NO_THROW(Maze{text});
  text.replace(text.find('G'), 1, "1");
  EXPECT_THROW(Maze{text}, InputError);
  text = kMaze;
  text.replace(text.find("1050"), 4, " 850");
  EXPECT_THROW(Maze{text}, InputError);
}

}  // namespace robosim::judge::maze_tries_test
