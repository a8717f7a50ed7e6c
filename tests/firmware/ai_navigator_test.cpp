// Tests AiNavigator: it explores a floor by itself, and then drives to any given station.
#include <robosim/testing.h>

#include "tests/firmware/explored.h"
#include "tests/firmware/maps.h"

namespace ai_navigator_test {

using namespace robosim::testing;
using testing::ContainsRegex;
using testing::StartsWith;

class AiNavigator : public RobotTest, public testing::WithParamInterface<std::string> {
 protected:
  AiNavigator() : RobotTest({.sketch = "AiNavigator", .map = kTee, .target = GetParam()}) {}

  void scan() {
    ASSERT_TRUE(robot().run_until(serial_says("press the button"), within(1_s)));
    robot().press("start");
    ASSERT_TRUE(robot().run_until(serial_says("destination?"), within(2_min)));
  }
  void go_to(int station) {
    robot().send(std::to_string(station) + "\n");
    const std::string arrived = "arrived at " + std::to_string(station);
    ASSERT_TRUE(robot().run_until(serial_says(arrived), within(1_min)));
    EXPECT_EQ(robot().station(), std::to_string(station));
  }
};

INSTANTIATE_TEST_SUITE_P(On, AiNavigator, Targets("host", "avr"), Named());

TEST_P(AiNavigator, WaitsForTheButtonBeforeItDrives) {
  EXPECT_THAT(robot().run_for(1_s), AllOf(NeverDrives(at_all()), SerialSays("press the button")));
  robot().press("start");
  ASSERT_TRUE(robot().run_until(motors_start(), within(500_ms)));
}

TEST_P(AiNavigator, FindsAllStationsAndJunctions) {
  scan();
  EXPECT_THAT(robot(), SerialSays("scan complete: 3 stations, 1 junction"));
  EXPECT_EQ(robot().stations_visited().size(), 3u);
  EXPECT_EQ(robot().station(), "1");
}

TEST_P(AiNavigator, SaysThatItIsReadyAndWhatItFindsEachOnce) {
  const Drive start = robot().run_until(serial_says("press the button"), within(1_s));
  EXPECT_THAT(start.serial(), StartsWith("ready\r\n"));
  robot().press("start");
  const std::string scan = robot().run_until(serial_says("destination?"), within(2_min)).serial();
  for (const char* what : {"station 1", "station 2", "station 3", "junction 1"})
    EXPECT_THAT(scan, ContainsRegex(std::string("found ") + what)) << what;
  std::size_t found = 0;
  for (std::size_t at = 0; (at = scan.find("found ", at)) != std::string::npos; ++at) ++found;
  EXPECT_EQ(found, 4u) << scan;
}

TEST_P(AiNavigator, AsksForAScanWhenItIsToDriveWithoutAMap) {
  ASSERT_TRUE(robot().run_until(serial_says("press the button"), within(1_s)));
  robot().send("2\n");
  EXPECT_THAT(robot().run_for(1_s),
              AllOf(SerialSays("I do not know where I am.\r\nPut me on a line"), NeverDrives(at_all())));
}

TEST_P(AiNavigator, DrivesToTheStationThatItIsTold) {
  scan();
  for (const int station : {3, 2, 1, 3, 2}) go_to(station);
  EXPECT_THAT(robot(), NeverCollides());
}

TEST_P(AiNavigator, TakesTheShortestWay) {
  scan();
  robot().send("2\n");
  const Drive way = robot().run_until(serial_says("arrived at 2"), within(1_min));
  ASSERT_TRUE(way);
  EXPECT_THAT(way, Not(Visits({3})));
}

TEST_P(AiNavigator, RefusesAStationThatDoesNotExist) {
  scan();
  robot().send("4\n");
  EXPECT_THAT(robot().run_for(2_s), AllOf(SerialSays("refused"), NeverDrives(at_all())));
}

TEST_P(AiNavigator, KnowsStationsByTheirNames) {
  scan();
  robot().send("shelf\n");
  ASSERT_TRUE(robot().run_until(serial_says("arrived at 3"), within(1_min)));
  robot().send("dock\n");
  ASSERT_TRUE(robot().run_until(serial_says("arrived at 2"), within(1_min)));
}

TEST_P(AiNavigator, RefusesWhatIsNoStation) {
  scan();
  for (const char* wrong : {"65538", "-1", "12", "docks", "shelter", "2 ", "doc"}) {
    robot().send(wrong + std::string("\n"));
    ASSERT_TRUE(robot().run_until(serial_says("refused. Stations: 1 home, 2 dock, 3 shelf\r\n"), within(1_s)))
        << wrong;
  }
  robot().send(std::string(60, 'x') + "\n");
  ASSERT_TRUE(robot().run_until(serial_says("refused"), within(1_s)));
  go_to(2);
}

TEST_P(AiNavigator, AnswersNothingToAnEmptyLine) {
  scan();
  robot().send("\r\n\n");
  EXPECT_THAT(robot().run_for(1_s), Not(SerialSays("refused")));
}

TEST_P(AiNavigator, NoticesThatItsMapIsDamaged) {
  scan();
  robot().act("fault eeprom flip 4 1");
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("My map is damaged."), within(2_s)));
}

TEST_P(AiNavigator, DoesNotTrustAPlaceThatIsDamaged) {
  constexpr int kPlace = 1021;
  scan();
  robot().act("fault eeprom flip " + std::to_string(kPlace) + " 1");  // names another station as the place
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("I do not know where I am"), within(2_s)));
}

TEST_P(AiNavigator, RemembersItsMapWhenItIsSwitchedOff) {
  scan();
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("I have a map: 3 stations, 1 junction"), within(2_s)));
  go_to(2);
}

TEST_P(AiNavigator, DoesNotTrustItsPlaceWhenItWasSwitchedOffUnderWay) {
  scan();
  robot().send("3\n");
  ASSERT_TRUE(robot().run_until(serial_says("way:"), within(1_s)));
  robot().run_for(1_s);
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("switched off under way"), within(2_s)));
  EXPECT_THAT(robot().run_for(2_s), NeverDrives(at_all()));
}

TEST_P(AiNavigator, StopsWhenItsBumperIsPressedAndGoesOnWhenTheWayIsFree) {
  scan();
  robot().send("3\n");
  ASSERT_TRUE(robot().run_until(serial_says("way:"), within(1_s)));
  robot().run_for(1_s);
  robot().press("bumper", 2_s);
  EXPECT_THAT(robot().run_for(1500_ms), StopsWithin(300_ms));
  ASSERT_TRUE(robot().run_until(serial_says("arrived at 3"), within(1_min)));
}

TEST_P(AiNavigator, LightsAnLedOnAJunctionAndTheSecondAtAStation) {
  scan();
  robot().send("3\n");
  robot().run_for(700_ms);
  EXPECT_FALSE(robot().is_on("LED") || robot().is_on("LED2")) << "on the line";
  ASSERT_TRUE(robot().run_until(turns_on("LED"), within(5_s)));
  robot().run_for(300_ms);
  EXPECT_FALSE(robot().is_on("LED") || robot().is_on("LED2")) << "on the next line";
  ASSERT_TRUE(robot().run_until(turns_on("LED2"), within(1_min)));
  EXPECT_EQ(robot().station(), "3");
}

// After a power cut the robot has either the complete, correct map or no map.
TEST(AiNavigatorsMemory, NeverHoldsAWrongGraphWhereverThePowerIsCut) {
  constexpr std::ptrdiff_t kEndOfMap = 1021;  // the bytes after the map store the robot's place
  std::vector<std::uint8_t> whole;
  AtEveryPowerCut({.sketch = "AiNavigator", .map = kTee}, [&](Simulation& robot) {
    const Event asks_for_a_scan = serial_says("press the button: I will scan.\r\n");
    ASSERT_TRUE(robot.run_until(asks_for_a_scan, within(1_s)));
    robot.press("start");
    ASSERT_TRUE(robot.run_until(serial_says("destination?") || asks_for_a_scan, within(2_min)));
    const std::vector<std::uint8_t> eeprom = robot.eeprom();
    const std::vector<std::uint8_t> map(eeprom.begin(), eeprom.begin() + kEndOfMap);
    if (whole.empty()) whole = map;  // the first run is without a power cut
    const Graph kept = explored(eeprom);
    if (kept.nodes.empty()) {
      EXPECT_THAT(robot, Not(SerialSays("I have a map")));
    } else {
      EXPECT_THAT(kept, IsTheSameGraphAs(robot.true_graph()));
      EXPECT_EQ(map, whole) << "the robot trusts an incomplete map";
    }
  });
}

class AiNavigatorOnMap : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Map, AiNavigatorOnMap, Maps("b", "warehouse"), Named());

TEST_P(AiNavigatorOnMap, ExploresTheGraphThatIsThere) {
  Simulation robot({.sketch = "AiNavigator", .map = GetParam()});
  ASSERT_TRUE(robot.run_until(serial_says("press the button"), within(1_s)));
  robot.press("start");
  ASSERT_TRUE(robot.run_until(serial_says("destination?"), within(20_min)));
  EXPECT_THAT(explored(robot.eeprom()), IsTheSameGraphAs(robot.true_graph()));
  EXPECT_THAT(robot, NeverCollides());
}

}  // namespace ai_navigator_test
