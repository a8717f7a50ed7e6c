// Tests fleets, which are runs of several robots. Checks the messages for invalid fleets. Also checks that a
// robot's run in a fleet equals the run of this robot alone.
#include <gmock/gmock.h>
#include <robosim/testing.h>

#include "sim/base/error.h"

namespace robosim::testing {
namespace fleet_test {

using ::testing::HasSubstr;

std::string refusal(const FleetTrial& trial) {
  try {
    Fleet fleet(trial);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(FleetTest, SaysWhatCannotBeRunAndOfWhichRobot) {
  EXPECT_THAT(refusal({}), HasSubstr("a FleetTrial requires robots"));
  EXPECT_THAT(refusal({.robots = {{.name = "A"}}}), HasSubstr("robot A requires a sketch"));
  EXPECT_THAT(
      refusal({.robots = {{.name = "A", .sketch = "PidFollower"}, {.name = "A", .sketch = "PidFollower"}}}),
      HasSubstr("two robots are named A"));
  EXPECT_THAT(refusal({.robots = {{.name = "A B", .sketch = "PidFollower"}}}),
              HasSubstr("invalid name of a robot"));
  EXPECT_THAT(refusal({.robots = {{.name = "A", .sketch = "PidFollower"},
                                  {.name = "B", .sketch = "PidFollower", .start = "99,2,W"}},
                       .map = "oval"}),
              HasSubstr("robot B: "));
  EXPECT_THAT(
      refusal({.robots = {{.name = "A", .sketch = "PidFollower"}, {.name = "B", .sketch = "PidFollower"}},
               .map = "oval"}),
      HasSubstr("robot B starts on top of robot A"));
}

TEST(FleetTest, NamesItsRobotsWhereOneIsUnknown) {
  Fleet fleet({.robots = {{.name = "A", .sketch = "PidFollower"}}, .map = "oval"});
  try {
    fleet.robot("C");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown robot: expected "));
  }
}

TEST(FleetTest, ARobotsRunIsTheOneItHasAlone) {
  Simulation alone({.sketch = "PidFollower", .map = "oval", .seed = 4});
  Fleet both({.robots = {{.name = "A", .sketch = "PidFollower"},
                         {.name = "B", .sketch = "PidFollower", .start = "20,2,W"}},
              .map = "oval",
              .seed = 4});
  alone.run_for(700_ms);
  both.robot("B").run_for(300_ms);
  both.robot("A").run_for(400_ms);
  EXPECT_EQ(both.robot("A").trace_hash(), alone.trace_hash());
}

}  // namespace fleet_test
}  // namespace robosim::testing
