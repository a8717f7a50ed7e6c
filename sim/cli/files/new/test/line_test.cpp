// Tests the sketch in C++, for requirements beyond checks.toml. CMakeLists.txt shows how to run the tests.
#include <robosim/testing.h>

using namespace robosim::testing;

TEST(Line, IsKeptToForALap) {
  Simulation robot({.sketch = ROBOSIM_SKETCH, .goal = "laps:1", .limit = 30_s});
  EXPECT_THAT(robot.run_to_the_end(), AllOf(Reaches("laps:1"), Follows(line(), within(30_mm))));
}
