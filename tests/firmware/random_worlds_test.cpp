// Tests the guarantees of Robosim's example sketches on random floors and robots, with mild faults. The
// environment variable ROBOSIM_TEST_SEEDS=1000 makes the tests try more worlds.
#include <robosim/random_worlds.h>

#include "tests/firmware/explored.h"

namespace random_worlds_test {

using namespace robosim::testing;

void tours_every_tree(const std::string& sketch) {
  InRandomWorlds({.trial = {.sketch = sketch, .goal = "tour", .limit = 10_min},
                  .maps = trees(12),
                  .robots = robots("uno3")},
                 runs(6), [](Simulation& robot) {
                   EXPECT_THAT(robot.run_to_the_end(), AllOf(Reaches("tour"), NeverCollides()));
                 });
}

TEST(LeftPathInRandomWorlds, VisitsEveryStationOfATreeAndComesHome) { tours_every_tree("LeftPath"); }

TEST(RightPathInRandomWorlds, VisitsEveryStationOfATreeAndComesHome) { tours_every_tree("RightPath"); }

TEST(AiNavigatorInRandomWorlds, FindsTheGraphThatIsThere) {
  InRandomWorlds({.trial = {.sketch = "AiNavigator"},
                  .maps = networks({.lines = 14, .cycles = 3}),
                  .robots = robots("uno5"),
                  .scripts = faults("uno5")},
                 runs(6), [](Simulation& robot) {
                   ASSERT_TRUE(robot.run_until(serial_says("press the button"), within(1_s)));
                   robot.press("start");
                   ASSERT_TRUE(robot.run_until(serial_says("destination?"), within(10_min)));
                   EXPECT_THAT(explored(robot.eeprom()), IsTheSameGraphAs(robot.true_graph()));
                   EXPECT_THAT(robot, NeverCollides());
                 });
}

TEST(PonyNavigatorInRandomWorlds, FindsAllStationsOfATree) {
  InRandomWorlds({.trial = {.sketch = "PonyNavigator"}, .maps = trees(8), .robots = robots("pony")}, runs(4),
                 [](Simulation& robot) {
                   ASSERT_TRUE(robot.run_until(serial_says("ready"), within(1_s)));
                   robot.press("scan");
                   ASSERT_TRUE(robot.run_until(serial_matches("^scan complete"), within(10_min)));
                   EXPECT_THAT(robot, SerialMatches("scan complete, stations: " +
                                                    std::to_string(robot.true_graph().stations()) + "\\b"));
                   EXPECT_THAT(robot, NeverCollides());
                 });
}

TEST(PidFollowerInRandomWorlds, KeepsToTheLineOfEveryTrackThoughASensorIsOff) {
  InRandomWorlds({.trial = {.sketch = "PidFollower", .goal = "laps:1", .limit = 2_min},
                  .maps = tracks({.apart = 4, .corner_mm = 200, .gaps = 0}),
                  .robots = robots("uno5"),
                  .scripts = faults("uno5")},
                 runs(6), [](Simulation& robot) {
                   const Drive lap = robot.run_to_the_end();
                   EXPECT_THAT(lap,
                               AllOf(Reaches("laps:1"), Follows(line(), within(25_mm)), NeverCollides()));
                 });
}

}  // namespace random_worlds_test
