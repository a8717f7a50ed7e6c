// Tests the image that the build compiled for the chip.
#include <robosim/testing.h>

using namespace robosim::testing;  // NOLINT

TEST(Image, FitsTheChipWithRoomToSpare) {
  Simulation robot({.sketch = ROBOSIM_SKETCH, .map = "oval"});
  ASSERT_TRUE(robot.run_until(serial_says("ready"), within(100_ms)));
  EXPECT_THAT(robot.run_for(1_s), UsesAtMost(ram(400), stack(200), flash(6000), loop_time(5_ms)));
}

TEST(AllTargets, AreThoseOfTheBuild) { EXPECT_THAT(target_names(), ::testing::ElementsAre("avr")); }
