// Tests two robots on one map. The firmware of the second robot runs on the host or on its chip.
#include <robosim/testing.h>

namespace fleet_test {

using namespace robosim::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Robot A follows its line. Robot B starts further along the same line, and follows it, too.
FleetTrial two(const std::string& target) {
  return {.robots =
              {{.name = "A", .sketch = "PidFollower", .goal = "laps:1"},
               {.name = "B", .sketch = "PidFollower", .target = target, .start = "20,2,W", .goal = "laps:1"}},
          .map = "oval"};
}

class TwoFollowers : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ROBOSIM_SKIP_WITHOUT(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Beside, TwoFollowers, testing::Values("host", "avr", "stm32"), Named());

TEST_P(TwoFollowers, BothComeRoundAndKeepApart) {
  Fleet both(two(GetParam()));
  both.run_to_the_end();
  EXPECT_TRUE(both.all_reached());
  EXPECT_THAT(both.robot("A"), AllOf(Reaches("laps:1"), NeverCollides(), Follows(line(), within(30_mm))));
  EXPECT_THAT(both.robot("B"), AllOf(Reaches("laps:1"), NeverCollides()));
}

TEST_P(TwoFollowers, EachIsAskedAndHandledByItsName) {
  Fleet both(two(GetParam()));
  Simulation &a = both.robot("A"), &b = both.robot("B");
  ASSERT_TRUE(b.run_until(motors_start(), within(1_s)));
  a.power_off(10_s);
  const Drive meanwhile = b.run_for(2_s);
  EXPECT_GT(meanwhile.distance().mm, 500);
  EXPECT_NEAR(a.pose().y_mm, 250, 5) << "A stays at the start of its line";
  EXPECT_GT(b.pose().y_mm, a.pose().y_mm);
  EXPECT_EQ(a.now(), b.now());
  EXPECT_EQ(both.now(), a.now());
  EXPECT_EQ(b.on_chip(), GetParam() != "host");
  ASSERT_TRUE(b.run_until(collides(), within(20_s))) << "A is in B's way";
  EXPECT_FALSE(both.over());
}

TEST_P(TwoFollowers, OneHasItsVerdictWhileTheOtherDrivesOn) {
  FleetTrial trial = two(GetParam());
  trial.robots[1].goal = "none";
  Fleet both(trial);
  both.robot("A").run_to_the_end();
  EXPECT_THAT(both.verdicts(), ElementsAre("reached", ""));
  const Pose there = both.robot("A").pose();
  EXPECT_GT(both.robot("B").run_for(500_ms).distance().mm, 100);
  EXPECT_EQ(both.robot("A").pose().x_mm, there.x_mm);
  EXPECT_THAT(both.all_reached().message(), HasSubstr("B drives on"));
  EXPECT_EQ(both.robot("A").verdict(), "reached");
}

}  // namespace fleet_test
