// Tests PidFollower: it follows a line fast, through bends and gaps, and never loses it.
#include <robosim/testing.h>

#include <algorithm>
#include <vector>

namespace pid_follower_test {

using namespace robosim::testing;

class PidFollower : public RobotTest, public testing::WithParamInterface<std::string> {
 protected:
  explicit PidFollower(Trial trial = {.map = "oval"}) : RobotTest(with_sketch(trial)) {}

 private:
  static Trial with_sketch(Trial trial) {
    trial.sketch = "PidFollower";
    trial.target = GetParam();
    return trial;
  }
};

INSTANTIATE_TEST_SUITE_P(On, PidFollower, Targets("host", "avr", "stm32"), Named());

TEST_P(PidFollower, StartsAtOnce) {
  ASSERT_TRUE(robot().run_until(motors_start(), within(50_ms)));
  EXPECT_THAT(robot().run_for(1_s), NeverDrives(backwards()));
  EXPECT_GT(robot().moment().speed.mm_per_s, 100.0);
}

TEST_P(PidFollower, KeepsToTheLineAllTheWayRound) {
  const Drive drive = robot().run_for(12_s);
  EXPECT_THAT(drive, Follows(line(), within(25_mm)));
  EXPECT_THAT(drive, NeverDrives(off_the_line()));
  EXPECT_GT(drive.distance().mm, 3000.0);
}

TEST_P(PidFollower, ComesBackToTheLineAfterAFingerOnASensor) {
  robot().run_for(1_s);
  robot().cover("S1", 100_ms);
  robot().run_for(1_s);
  EXPECT_THAT(robot().run_for(4_s), Follows(line(), within(25_mm)));
}

TEST_P(PidFollower, ComesBackToTheLineAfterItWasPushedOff) {
  robot().run_for(1_s);
  robot().act("fault left stuck for 400ms");
  robot().run_for(100_ms);
  for (const char* sensor : {"S1", "S2", "S3", "S4", "S5"})
    robot().act("fault " + std::string(sensor) + " stuck 60 for 250ms");
  robot().run_for(4_s);  // a millisecond's difference changes how often and where the robot swings
  EXPECT_THAT(robot().run_for(2_s), Follows(line(), within(25_mm)));
}

TEST_P(PidFollower, KeepsTheLineUnderItsMiddle) {
  robot().run_for(500_ms);
  std::vector<double> off;
  for (const Moment& moment : robot().run_for(4_s).moments()) off.push_back(moment.cross_track.mm);
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 4.0) << "median in mm";
}

TEST_P(PidFollower, LeavesTheChipRoomAndComesRoundEveryTenMilliseconds) {
  if (!robot().on_chip()) GTEST_SKIP() << "requires a chip's memory";
  robot().run_for(3_s);
  EXPECT_THAT(robot(), UsesAtMost(ram(600), stack(300), flash(12000), loop_time(10_ms)));
}

class PidFollowerMeasuringItsRange : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ROBOSIM_SKIP_WITHOUT(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(On, PidFollowerMeasuringItsRange, Targets("host", "avr"), Named());

TEST_P(PidFollowerMeasuringItsRange, TurnsToAndFroFirstAndThenFollowsTheLine) {
  Simulation robot(
      {.sketch = "PidFollower", .map = "oval", .target = GetParam(), .script = "at 0s press start 200ms"});
  const Drive measuring = robot.run_for(1900_ms);
  EXPECT_LT(measuring.distance().mm, 100.0) << "the robot turns on the spot";
  robot.run_for(1_s);
  EXPECT_THAT(robot.run_for(4_s), Follows(line(), within(25_mm)));
}

class PidFollowerOnManySeeds : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Seed, PidFollowerOnManySeeds, Seeds(1, 3), Named());

TEST_P(PidFollowerOnManySeeds, LapsTheOvalTwice) {
  Simulation robot({.sketch = "PidFollower", .map = "oval", .seed = GetParam(), .goal = "laps:2"});
  EXPECT_THAT(robot.run_to_the_end(), Reaches("laps:2"));
}

class PidFollowerOnEveryLoop : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Map, PidFollowerOnEveryLoop, Maps("oval", "tight", "dashed"), Named());

TEST_P(PidFollowerOnEveryLoop, DrivesALap) {
  Simulation robot({.sketch = "PidFollower", .map = GetParam(), .goal = "laps:1"});
  EXPECT_THAT(robot.run_to_the_end(), Reaches("laps:1"));
}

}  // namespace pid_follower_test
