// Failing tests of sketches with bugs. docs/howto/testing.md shows their messages.
#include <robosim/random_worlds.h>

namespace {

using namespace robosim::testing;

TEST(TooFast, KeepsToTheLine) {
  Simulation robot({.sketch = "./TooFast", .map = "oval", .seed = 3});
  ASSERT_TRUE(robot.run_until(serial_says("go"), within(1_s)));
  robot.cover("S3", 50_ms);
  EXPECT_THAT(robot.run_for(5_s), Follows(line(), within(15_mm)));
}

TEST(WrongButton, DrivesWhenTheButtonIsPressed) {
  Simulation robot({.sketch = "./WrongButton", .map = "oval"});
  ASSERT_TRUE(robot.run_until(serial_says("Ready"), within(1_s)));
  robot.press("start");
  ASSERT_TRUE(robot.run_until(motors_start(), within(500_ms)));
}

TEST(Forgetful, VisitsTheStations) {
  Simulation robot({.sketch = "./Forgetful", .map = "d", .robot = "uno3", .goal = "tour"});
  EXPECT_THAT(robot.run_to_the_end(), Visits({2, 3}));
}

TEST(StopsAtTees, ToursEveryTree) {
  InRandomWorlds({.trial = {.sketch = "./StopsAtTees", .robot = "uno3", .goal = "tour", .limit = 1_min},
                  .maps = trees()},
                 runs(20), [](Simulation& robot) { EXPECT_THAT(robot.run_to_the_end(), Reaches("tour")); });
}

TEST(InTheWay, NobodyIsTouched) {
  Fleet both({.robots = {{.name = "A", .sketch = "./TooFast"},
                         {.name = "B", .sketch = "./TooFast", .target = "host", .start = "20,2,W"}},
              .map = "oval",
              .seed = 3});
  both.robot("B").power_off(10_s);
  EXPECT_THAT(both.robot("A").run_for(5_s), NeverCollides());
}

TEST(PassesBy, StopsAtAStation) {
  Simulation robot({.sketch = "./TooFast", .map = "oval", .seed = 3});
  robot.run_for(1_s);
  EXPECT_EQ(robot.station(), "3");
  EXPECT_EQ(robot.verdict(), "reached");
}

TEST(Diary, StartsAfreshAtEveryPowerCut) {
  AtEveryPowerCut({.sketch = "../sketches/Diary"}, [](Simulation& robot) {
    robot.run_for(100_ms);
    EXPECT_EQ(robot.serial().find("was 0"), std::string::npos);
  });
}

}  // namespace
