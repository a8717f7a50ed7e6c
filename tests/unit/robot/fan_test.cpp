// Tests fans that press the robot to the floor.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/units.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace fan_test {

constexpr Pin kFan = 11;

// Returns a robot whose tyres slip at full power.
std::string slippery() {
  std::string robot = kBareRobot;
  robot.insert(robot.find("wheel ="), "grip = 0.1\n");
  return robot +
         "[[part]]\nname = \"fan\"\ntype = \"fan\"\npin = 11\ndownforce = \"200 g\"\nspin_up = \"100 ms\"\n";
}

class Fan : public testing::Test {
 protected:
  BenchRobot bench{parse_description(slippery(), "bench.toml")};

  /// Starts from rest at full power. Returns the mean acceleration during 100 ms, in m/s2.
  double acceleration() {
    bench.body().place({bench.line(), {1.0, 0.0}});
    for (const world::Side side : {world::left, world::right}) bench.body().command(side, {1.0, 0.0});
    bench.ticks(100);
    for (const world::Side side : {world::left, world::right}) bench.body().command(side, {});
    return bench.body().speed() / 0.1;
  }
};

TEST_F(Fan, LetsTyresHoldMoreAsItRunsFaster) {
  constexpr double kMass = 0.3, kGrip = 0.1, kLoadShare = 0.8, kFanMass = 0.2;
  const auto holds = [&](double speed) {
    return kGrip * (kLoadShare * kMass + kFanMass * speed * speed) * kGravity / kMass;
  };
  EXPECT_NEAR(acceleration(), holds(0.0), 0.01 * holds(0.0));
  bench.board.pwm(kFan, 0.5, bench.now);
  bench.ticks(2000);
  EXPECT_NEAR(acceleration(), holds(0.5), 0.01 * holds(0.5));
  bench.board.output(kFan, true, bench.now);
  bench.ticks(2000);
  EXPECT_NEAR(acceleration(), holds(1.0), 0.01 * holds(1.0));
  bench.board.output(kFan, false, bench.now);
  bench.ticks(2000);
  EXPECT_NEAR(acceleration(), holds(0.0), 0.01 * holds(0.0));
}

TEST_F(Fan, TakesItsTimeToSpinUp) {
  const auto speed = [&] { return bench.robot.readings().front().value; };
  EXPECT_EQ(speed(), 0.0);
  bench.board.output(kFan, true, bench.now);
  bench.ticks(100);
  EXPECT_NEAR(speed(), 1.0 - std::exp(-1.0), 0.01);
}

}  // namespace fan_test
}  // namespace robosim::robot
