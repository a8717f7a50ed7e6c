// Tests Shuttle, which measures distance in an interrupt handler.
#include <robosim/testing.h>

#include <regex>

#include "tests/firmware/sketches.h"

namespace shuttle_test {

using namespace robosim::testing;

/// A straight line of one metre.
constexpr const char* kTrack = R"(+++
name = "track"
+++
_______________
_______________
__S..........__
_______________
_______________
)";

class Shuttle : public RobotTest, public testing::WithParamInterface<std::string> {
 protected:
  Shuttle() : RobotTest({.sketch = test_sketch("Shuttle"), .map = kTrack, .target = GetParam()}) {}
};

INSTANTIATE_TEST_SUITE_P(On, Shuttle, AllTargets(), Named());

TEST_P(Shuttle, DrivesTwentyCentimetresForwardAndBackAgainAndAgain) {
  for (int i = 0; i < 3; ++i) {
    const double before = robot().pose().x_mm;
    ASSERT_TRUE(robot().run_until(serial_says("forward"), within(3_s)));
    EXPECT_NEAR(robot().pose().x_mm - before, 205, 10) << "the robot coasts a few millimetres";
    const double there = robot().pose().x_mm;
    ASSERT_TRUE(robot().run_until(serial_says("back"), within(3_s)));
    EXPECT_NEAR(there - robot().pose().x_mm, 205, 10);
  }
}

TEST_P(Shuttle, SaysHowFarItHasComeAndHowSoonItsWheelStarted) {
  const Drive leg = robot().run_until(serial_matches("forward \\d+ mm.*us"), within(3_s));
  ASSERT_TRUE(leg);
  std::smatch figures;
  const std::string text = leg.serial();
  ASSERT_TRUE(std::regex_search(text, figures, std::regex("forward (\\d+) mm, .* (\\d+) us")));
  EXPECT_NEAR(std::stod(figures[1]), leg.distance().mm, 6);
  EXPECT_GT(std::stoi(figures[2]), 1000);
  EXPECT_LT(std::stoi(figures[2]), 100000);
}

}  // namespace shuttle_test
