// AiNavigator where something is not as it was: it is carried away, an obstacle stays, the power fails.
#include <robosim/testing.h>

#include <chrono>
#include <optional>

#include "firmware/src/nav/Plan.h"
#include "tests/firmware/explored.h"
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
______._____._____._____
______._____._____._____
______............._____
________________________
________________________
________________________
)";

/// A ring that is long enough for wheels that are not alike to lead astray who reckons by them alone.
constexpr const char* kLongRing = R"(+++
name = "long ring"
corner = "250 mm"
+++
___________________________________
___________________________________
___________________________________
___S............................___
______._______________________.____
______._______________________.____
______._______________________.____
______._______________________.____
______.........................____
___________________________________
___________________________________
___________________________________
)";

/// Its left wheel seems to run half a percent less far than it does.
constexpr const char* kUnequalWheels = R"(
base = "uno5"
remove = ["encoder_left"]

[[part]]
name = "encoder_left"
type = "encoder"
pins = { a = 2 }
periods = 153.6
)";

class AiNavigatorAgain : public testing::Test {
 protected:
  void put_on(const char* map, const std::string& start = "", const std::string& robot = "") {
    robot_.emplace(Trial{.sketch = "AiNavigator", .map = map, .robot = robot, .start = start});
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
      {"3", "way: junction 1 right, junction 2 left, station 3"},
      {"2", "way: junction 2 left, junction 3 right, station 2"},
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

TEST_F(AiNavigatorAgain, KnowsWhereJunctionsAreAndHowLongLinesThoughItsWheelsAreNotAlike) {
  put_on(kLongRing, "", kUnequalWheels);
  scan();
  EXPECT_THAT(robot(), SerialSays("scan complete: 2 stations, 2 junctions"));
  const nav::FixedNetwork<60> map = map_in(robot().eeprom());
  ASSERT_EQ(map.junctions(), 2);
  const std::uint8_t near = map.link(0, 0), far = map.parent(nav::stationNode(map, std::uint8_t(2)));
  for (const auto& [junction, cells] : {std::pair{near, 3}, {far, 27}}) {
    EXPECT_NEAR(map.place(junction).x, 100 * cells, 50);
    EXPECT_NEAR(map.place(junction).y, 0, 50);
  }
  const double cruise = 300, units_per_s = 50;
  EXPECT_NEAR(map.cost(near, nav::slotTowards(map, near, far)), 2400 / cruise * units_per_s, 40);
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
  ASSERT_TRUE(robot().run_until(serial_says("collision: waiting"), within(1_min)));
  const Drive wait = robot().run_until(motors_start(), within(4500_ms));
  ASSERT_TRUE(wait) << "its patience is 4 s";
  EXPECT_GT(wait.end() - wait.begin(), 3500_ms);
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

TEST_F(AiNavigatorAgain, SaysWhatIsWrongWhereThereIsNothingToScan) {
  for (const auto& [map, said] :
       {std::pair{"oval", "There is no station and no junction here."}, {kTee, "I have lost the line."}}) {
    put_on(map);
    ASSERT_TRUE(robot().run_until(serial_says("press the button"), within(1_s)));
    if (map == kTee) robot().act("erase 3,3 9,3");
    robot().press("start");
    ASSERT_TRUE(robot().run_until(serial_says(said), within(1_min)));
    robot().send("1\n");
    ASSERT_TRUE(robot().run_until(serial_says("refused: I do not know where I am."), within(1_s)));
  }
}

TEST_F(AiNavigatorAgain, KnowsWhatItHasFoundIfAnObstacleCutsItsScanShort) {
  put_on(kTee);
  ASSERT_TRUE(robot().run_until(serial_says("press the button"), within(1_s)));
  robot().press("start");
  ASSERT_TRUE(robot().run_until(serial_says("found station 2"), within(1_min)));
  robot().act("obstacle 6,4");
  ASSERT_TRUE(robot().run_until(serial_says("An obstacle has cut the scan short; there is more than I know: "
                                            "2 stations, 1 junction"),
                                within(1_min)));
  ASSERT_TRUE(robot().run_until(serial_says("destination?"), within(1_s)));
  EXPECT_EQ(robot().station(), "2");
}

TEST_F(AiNavigatorAgain, StopsAndSaysSoBetweenTwoObstacles) {
  put_on(kWideRing);
  scan();
  robot().send("2\n");
  ASSERT_TRUE(robot().run_until(turns_on("LED"), within(10_s)));
  robot().run_for(2_s);
  robot().act("obstacle 16,3");
  robot().act("obstacle 7,3");
  ASSERT_TRUE(robot().run_until(serial_says("There are obstacles before and behind me."), within(1_min)));
  EXPECT_THAT(robot().run_for(2_s), NeverDrives(at_all()));
}

TEST_F(AiNavigatorAgain, SaysHowLongItsScanTook) {
  put_on(kTee);
  ASSERT_TRUE(robot().run_until(serial_says("press the button"), within(1_s)));
  robot().run_for(3_s);
  robot().press("start");
  ASSERT_TRUE(robot().run_until(serial_says("scanning"), within(1_s)));
  const Drive scan = robot().run_until(serial_says("scan complete"), within(1_min));
  ASSERT_TRUE(scan);
  const auto seconds = std::chrono::floor<std::chrono::seconds>(scan.end() - scan.begin()).count();
  const std::string said = "3 stations, 1 junction, " + std::to_string(seconds) + " s\r\n";
  ASSERT_TRUE(robot().run_until(serial_says(said), within(100_ms)));
}

TEST_F(AiNavigatorAgain, ForgetsWhereItStoodWhenItScansAnew) {
  put_on(kTee);
  scan();
  robot().run_for(500_ms);
  robot().press("start");
  ASSERT_TRUE(robot().run_until(serial_says("scanning"), within(1_s)));
  robot().run_for(2_s);
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("switched off under way"), within(2_s)));
}

TEST_F(AiNavigatorAgain, BeepsShortlyWhenItIsDoneAndForLongWhenSomethingIsWrong) {
  put_on(kTee);
  ASSERT_TRUE(robot().run_until(serial_says("press the button"), within(1_s)));
  robot().press("start");
  ASSERT_TRUE(robot().run_until(serial_says("scan complete"), within(1_min)));
  robot().run_for(80_ms);
  EXPECT_NEAR(robot().reading("buzzer"), 1760, 2) << "the scan is complete: for 100 ms";
  robot().run_for(40_ms);
  EXPECT_EQ(robot().reading("buzzer"), 0);
  robot().send("9\n");
  robot().run_for(780_ms);
  EXPECT_NEAR(robot().reading("buzzer"), 440, 2) << "there is no such station: for 800 ms";
  robot().run_for(40_ms);
  EXPECT_EQ(robot().reading("buzzer"), 0);
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
