// Tests the sketch PonyNavigator on the robot `pony`. The sketch explores a tree of lines and obeys radio
// commands.
#include <robosim/testing.h>

#include <algorithm>

#include "tests/firmware/maps.h"

namespace pony_navigator_test {

using namespace robosim::testing;

class PonyNavigator : public RobotTest, public testing::WithParamInterface<std::string> {
 protected:
  PonyNavigator()
      : RobotTest({.sketch = "PonyNavigator", .map = kTee, .robot = "pony", .target = GetParam()}) {}

  void scan() {
    ASSERT_TRUE(robot().run_until(serial_says("ready"), within(1_s)));
    robot().press("scan");
    ASSERT_TRUE(robot().run_until(serial_matches("^scan complete"), within(5_min)));
  }
  void go_to(int station) {
    robot().act("send radio " + std::to_string(station));
    const std::string arrived = "at station " + std::to_string(station);
    ASSERT_TRUE(robot().run_until(serial_says(arrived), within(2_min)));
    EXPECT_EQ(robot().station(), std::to_string(station));
  }
};

INSTANTIATE_TEST_SUITE_P(On, PonyNavigator, Targets("host", "avr"), Named());

TEST_P(PonyNavigator, StandsStillUntilItIsToldWhatToDo) {
  EXPECT_THAT(robot().run_for(1_s), NeverDrives(at_all()));
}

TEST_P(PonyNavigator, FindsAllStations) {
  scan();
  EXPECT_THAT(robot(), AllOf(SerialMatches("^scanning"), SerialMatches("scan complete, stations: 3")));
  EXPECT_EQ(robot().stations_visited().size(), 3u);
}

TEST_P(PonyNavigator, DrivesToTheStationThatTheRadioSays) {
  scan();
  go_to(3);
  go_to(2);
  go_to(1);
  EXPECT_THAT(robot(), AllOf(NeverCollides(), Not(SerialSays("refused"))));
}

TEST_P(PonyNavigator, ShowsWhereItIs) {
  scan();
  EXPECT_EQ(robot().reading("ones"), 1);
  EXPECT_EQ(robot().reading("tens"), -1) << "dark";
  go_to(2);
  EXPECT_EQ(robot().reading("ones"), 2);
}

TEST_P(PonyNavigator, LightsOneLedForJunctionLineEndOrDriving) {
  const auto lights = [this] {
    std::string on;
    for (const char* led : {"LED1", "LED2", "LED3"})
      if (robot().is_on(led)) on += led;
    return on;
  };
  scan();
  EXPECT_EQ(lights(), "LED2") << "at the end of a line";
  robot().act("send radio 2");
  robot().run_for(2_s);
  EXPECT_EQ(lights(), "LED3") << "on the way";
  ASSERT_TRUE(robot().run_until(turns_on("LED1"), within(1_min)));
  EXPECT_EQ(lights(), "LED1") << "at the junction";
}

TEST_P(PonyNavigator, RefusesAStationThatDoesNotExist) {
  scan();
  robot().act("send radio 9");
  EXPECT_THAT(robot().run_for(2_s), AllOf(SerialSays("refused: no such station"), NeverDrives(at_all())));
}

TEST_P(PonyNavigator, RefusesToDriveBeforeItKnowsWhereItIs) {
  ASSERT_TRUE(robot().run_until(serial_says("ready"), within(1_s)));
  robot().act("send radio 2");
  EXPECT_THAT(robot().run_for(2_s), AllOf(SerialSays("refused: where am I?"), NeverDrives(at_all())));
}

TEST_P(PonyNavigator, KeepsItsMapThroughAPowerCycle) {
  scan();
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("map in memory, stations: 3"), within(2_s)));
  robot().run_for(500_ms);
  robot().press("station1");
  ASSERT_TRUE(robot().run_until(serial_says("at station 1"), within(5_s)));
  go_to(2);
}

TEST_P(PonyNavigator, WaitsBeforeAnObstacleUntilTheWayIsFree) {
  scan();
  robot().act("send radio 3");
  ASSERT_TRUE(robot().run_until(serial_says("to station 3"), within(2_s)));
  robot().run_for(1_s);
  robot().press("bumper", 2_s);
  EXPECT_THAT(robot().run_for(1500_ms), StopsWithin(300_ms));
  ASSERT_TRUE(robot().run_until(serial_says("at station 3"), within(2_min)));
}

TEST_P(PonyNavigator, GivesUpBeforeAnObstacleThatStays) {
  scan();
  robot().act("send radio 3");
  ASSERT_TRUE(robot().run_until(serial_says("to station 3"), within(2_s)));
  robot().run_for(1_s);
  robot().press("bumper", 6_s);
  ASSERT_TRUE(robot().run_until(serial_says("no way: there is an obstacle"), within(1_min)));
  go_to(1);
}

TEST(PonyNavigatorsObstacle, MakesTheRobotBackOffBeforeItTurns) {
  Simulation robot({.sketch = "PonyNavigator", .map = kTee, .robot = "pony"});
  ASSERT_TRUE(robot.run_until(serial_says("ready"), within(1_s)));
  robot.press("scan");
  ASSERT_TRUE(robot.run_until(serial_matches("^scan complete"), within(5_min)));
  robot.act("obstacle 9,3");
  robot.act("send radio 3");
  const Drive way = robot.run_until(serial_says("no way: there is an obstacle"), within(1_min));
  ASSERT_TRUE(way);
  double met = 0, turned = 0;  // farthest x positions
  for (const Moment& moment : way.moments()) {
    met = std::max(met, moment.pose.x_mm);
    if (moment.left * moment.right < 0) turned = std::max(turned, moment.pose.x_mm);
  }
  EXPECT_LT(turned, met - 25);
  robot.act("clear 9,3");
  robot.act("send radio 2");
  ASSERT_TRUE(robot.run_until(serial_says("at station 2"), within(2_min)));
}

TEST(PonyNavigatorsRefusals, SayWhy) {
  Simulation robot({.sketch = "PonyNavigator", .map = kTee, .robot = "pony"});
  const auto is_told = [&](const char* button, const char* answer) {
    robot.press(button);
    return robot.run_until(serial_says(answer), within(1_min));
  };
  ASSERT_TRUE(robot.run_until(serial_says("ready"), within(1_s)));
  ASSERT_TRUE(is_told("station1", "no map: scan first"));
  robot.run_for(900_ms);
  EXPECT_TRUE(robot.is_on("buzzer")) << "beeps for a second";
  robot.run_for(200_ms);
  EXPECT_FALSE(robot.is_on("buzzer"));
  ASSERT_TRUE(is_told("scan", "scan complete, stations: 3"));
  robot.act("send radio 0b0000001");
  ASSERT_TRUE(robot.run_until(serial_says("refused: not 8 bits"), within(1_s)));
  robot.run_for(500_ms);
  robot.place(6, 3, 'E');
  ASSERT_TRUE(is_told("station1", "this is not the end of a line"));
  robot.act("erase 3,3 9,3");
  robot.act("erase 6,3 6,6");
  ASSERT_TRUE(is_told("scan", "lost the line"));
  robot.act("send radio 1");
  ASSERT_TRUE(robot.run_until(serial_says("refused: where am I?"), within(1_s)));
}

TEST(PonyNavigatorsDigits, ShowTheTensToo) {
  Simulation robot({.sketch = "PonyNavigator", .map = kComb, .robot = "pony"});
  ASSERT_TRUE(robot.run_until(serial_says("ready"), within(1_s)));
  robot.press("scan");
  ASSERT_TRUE(robot.run_until(serial_matches("^scan complete, stations: 12"), within(10_min)));
  robot.act("send radio 12");
  ASSERT_TRUE(robot.run_until(serial_says("at station 12"), within(2_min)));
  EXPECT_EQ(robot.reading("tens"), 1);
  EXPECT_EQ(robot.reading("ones"), 2);
}

}  // namespace pony_navigator_test
