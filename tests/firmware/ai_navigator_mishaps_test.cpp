// AiNavigator where something is not as it was: it is carried away, an obstacle stays, the power fails.
#include <robosim/testing.h>

#include <optional>

#include "tests/firmware/maps.h"

namespace {

using namespace robosim::testing;
using testing::HasSubstr;

/// Two junctions on the way from station 1 to station 2, and two ways between them: straight on, 4 cells, or
/// round by the south, 16.
constexpr const char* kRing = R"(+++
name = "ring"
+++
_________________
_________________
_________________
___S..........___
______.___.______
______.___.______
______.___.______
______.___.______
______.___.______
______.....______
_________________
_________________
_________________
)";

/// The same with a third junction on the way round, of 20 cells, and a station there: straight on it is 12.
constexpr const char* kWideRing = R"(+++
name = "wide ring"
+++
________________________
________________________
________________________
___S.................___
______.___________._____
______.___________._____
______.___________._____
______............._____
____________.___________
____________.___________
____________.___________
________________________
________________________
________________________
)";

class AiNavigatorAgain : public testing::Test {
 protected:
  void put_on(const char* map, const std::string& start = "") {
    robot_.emplace(Trial{.sketch = "AiNavigator", .map = map, .start = start});
  }
  Simulation& robot() { return *robot_; }
  void scan() {
    ASSERT_TRUE(robot().run_until(serial_says("press the button"), within(1_s)));
    robot().press("start");
    ASSERT_TRUE(robot().run_until(serial_says("destination?"), within(5_min)));
  }
  Drive go_to(const std::string& station) {
    robot().send(station + "\n");
    return robot().run_until(serial_says("arrived at " + station), within(2_min));
  }

 private:
  std::optional<Simulation> robot_;
};

TEST_F(AiNavigatorAgain, TakesTheShorterOfTwoWaysRound) {
  put_on(kRing);
  scan();
  const Drive way = go_to("2");
  ASSERT_TRUE(way);
  EXPECT_THAT(way.serial(), HasSubstr("straight, junction"));
  EXPECT_LT(way.distance().mm, 1300.0);
  const Drive back = go_to("1");
  ASSERT_TRUE(back);
  EXPECT_THAT(back.serial(), HasSubstr("straight, junction"));
  EXPECT_LT(back.distance().mm, 1300.0);
}

TEST_F(AiNavigatorAgain, TakesTheShorterOfTwoWaysOverOtherJunctions) {
  put_on(kWideRing);
  scan();
  const std::pair<const char*, const char*> ways[] = {
      {"2", "way: junction 1 right, junction 2 right, station 2"},
      {"3", "way: junction 2 right, junction 3 right, station 3"},
      {"1", "way: junction 3 straight, junction 1 straight, station 1"}};
  for (const auto& [station, said] : ways) {
    const Drive way = go_to(station);
    ASSERT_TRUE(way);
    EXPECT_THAT(way.serial(), HasSubstr(said));
    EXPECT_LT(way.distance().mm, 1900.0) << "to station " << station;
  }
}

TEST_F(AiNavigatorAgain, FindsItsWayWhereBendsAreRound) {
  put_on(("+++\ncorner = \"250 mm\"" + std::string(kRing + 3)).c_str());
  scan();
  EXPECT_THAT(robot(), SerialSays("scan complete: 2 stations, 2 junctions"));
  const Drive way = go_to("2");
  ASSERT_TRUE(way);
  EXPECT_EQ(robot().station(), "2");
  EXPECT_LT(way.distance().mm, 1300.0);
}

TEST_F(AiNavigatorAgain, DrivesOverTwoJunctionsAfterItWasSwitchedOff) {
  put_on(kRing);
  scan();
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("I have a map: 2 stations, 2 junctions"), within(2_s)));
  ASSERT_TRUE(go_to("2"));
  EXPECT_EQ(robot().station(), "2");
  ASSERT_TRUE(go_to("1"));
  EXPECT_EQ(robot().station(), "1");
}

TEST_F(AiNavigatorAgain, NoticesThatItWasCarriedElsewhereWhileItWasOff) {
  put_on(kTee);
  scan();
  robot().place(8, 3, 'E');
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("destination?"), within(2_s)));
  robot().send("2\n");
  ASSERT_TRUE(robot().run_until(serial_says("this is not where I was switched off"), within(10_s)));
  EXPECT_THAT(robot().run_for(1_s), NeverDrives(at_all()));
  robot().send("2\n");
  ASSERT_TRUE(robot().run_until(serial_says("refused: I do not know where I am."), within(1_s)));
}

TEST_F(AiNavigatorAgain, GoesRoundAnObstacleThatStays) {
  put_on(kRing);
  scan();
  robot().act("obstacle 8,3");
  ASSERT_TRUE(go_to("2"));
  EXPECT_EQ(robot().station(), "2");
  EXPECT_THAT(robot(), AllOf(SerialSays("an obstacle: going back"), Not(SerialSays("going on"))));
}

TEST_F(AiNavigatorAgain, SaysThatThereIsNoWayRoundAnObstacleThatStays) {
  put_on(kTee);
  scan();
  robot().act("obstacle 8,3");
  robot().send("3\n");
  ASSERT_TRUE(robot().run_until(serial_says("no way to 3"), within(1_min)));
  robot().act("clear 8,3");
  ASSERT_TRUE(go_to("2"));
  EXPECT_EQ(robot().station(), "2");
}

TEST_F(AiNavigatorAgain, ScansFromAJunctionOrTheMiddleOfALine) {
  for (const char* start : {"6,3,E", "8,3,W"}) {
    put_on(kTee, start);
    scan();
    EXPECT_THAT(robot(), SerialSays("scan complete: 3 stations, 1 junction")) << start;
    ASSERT_TRUE(go_to("2")) << start;
    EXPECT_EQ(robot().station(), "2");
  }
}

TEST_F(AiNavigatorAgain, SaysThatItGoesOnWhenItDoes) {
  put_on(kTee);
  scan();
  robot().send("3\n");
  ASSERT_TRUE(robot().run_until(serial_says("way:"), within(1_s)));
  robot().run_for(1_s);
  robot().press("bumper", 2_s);
  ASSERT_TRUE(robot().run_until(serial_says("collision: waiting"), within(500_ms)));
  const Drive held = robot().run_for(1900_ms);
  EXPECT_THAT(held, Not(SerialSays("going on")));
  ASSERT_TRUE(robot().run_until(serial_says("going on"), within(1_s)));
  ASSERT_TRUE(robot().run_until(motors_start(), within(100_ms)));
}

}  // namespace
