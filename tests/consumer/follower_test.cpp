// Tests the sketch's behaviour on every target.
#include <robosim/testing.h>

using namespace robosim::testing;  // NOLINT

class Follower : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ROBOSIM_SKIP_WITHOUT(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(On, Follower, AllTargets(), Named());

TEST_P(Follower, KeepsToTheLineForALap) {
  Simulation robot({.sketch = ROBOSIM_SKETCH, .map = "oval", .target = GetParam(), .goal = "laps:1"});
  EXPECT_THAT(robot.run_to_the_end(), ::testing::AllOf(Reaches("laps:1"), Follows(line(), within(30_mm))));
}

TEST_P(Follower, SaysThatItIsReady) {
  Simulation robot({.sketch = ROBOSIM_SKETCH, .map = "oval", .target = GetParam()});
  EXPECT_TRUE(robot.run_until(serial_says("ready"), within(100_ms)));
}
