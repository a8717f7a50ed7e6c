// The sketch's tests in C++, for what checks.toml cannot say. CMakeLists.txt says how to run them.
#include <robosim/testing.h>

using namespace robosim::testing;

TEST(Line, IsKeptToForALap) {
  Simulation robot({.sketch = ROBOSIM_SKETCH, .goal = "laps:1", .limit = 30_s});
  EXPECT_THAT(robot.run_to_the_end(), AllOf(Reaches("laps:1"), Follows(line(), within(30_mm))));
}
