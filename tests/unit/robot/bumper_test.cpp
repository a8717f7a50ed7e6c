// Tests bumper switches. Obstacles press them, and a script can press them like buttons.
#include <gtest/gtest.h>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace bumper_test {

const std::string kBumper = "[[part]]\nname = \"bumper\"\ntype = \"bumper\"\npin = 4\nresistor = true\n";

/// A robot of 60 mm radius, and a disc of 20 mm radius. The disc's centre is 100 mm from the robot's centre,
/// in direction `away`. drive() sets both motors to duty cycle `speed` for 400 ms.
struct Crash {
  BenchRobot bench{kBumper};

  explicit Crash(Vec2 away) {
    bench.world.add_obstacle(bench.line() + away * 0.1, 0.02);
    bench.body().place({bench.line(), {1.0, 0.0}});
  }
  void drive(double speed) {
    for (const world::Side side : {world::left, world::right}) bench.body().command(side, {speed, 0.0});
    bench.ticks(400);
  }
};

TEST(Bumper, IsPressedByWhatStandsAheadAndReleasedBehindIt) {
  Crash crash({1.0, 0.0});
  EXPECT_TRUE(crash.bench.level(4));
  crash.drive(0.3);
  EXPECT_TRUE(crash.bench.body().in_contact());
  EXPECT_FALSE(crash.bench.level(4));
  crash.drive(0.0);
  EXPECT_FALSE(crash.bench.level(4)) << "the robot still touches the disc";
  crash.drive(-0.1);
  EXPECT_TRUE(crash.bench.level(4));
}

TEST(Bumper, DoesNotFeelWhatItBacksInto) {
  Crash crash({-1.0, 0.0});
  crash.drive(-0.3);
  EXPECT_TRUE(crash.bench.body().in_contact());
  EXPECT_TRUE(crash.bench.level(4));
}

TEST(Bumper, CanBePressedByHandLikeAButton) {
  BenchRobot bench(kBumper);
  bench.robot.press("bumper", 0);
  bench.ticks(5);
  EXPECT_FALSE(bench.level(4));
  bench.robot.release("bumper", bench.now);
  bench.ticks(5);
  EXPECT_TRUE(bench.level(4));
}

TEST(Bumper, StaysPressedByAnObstacleWhenTheHandLetsGo) {
  Crash crash({1.0, 0.0});
  crash.drive(0.3);
  crash.bench.robot.press("bumper", crash.bench.now);
  crash.bench.ticks(5);
  crash.bench.robot.release("bumper", crash.bench.now);
  crash.bench.ticks(5);
  EXPECT_FALSE(crash.bench.level(4));
}

}  // namespace bumper_test
}  // namespace robosim::robot
