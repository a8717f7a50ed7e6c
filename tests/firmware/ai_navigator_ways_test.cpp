// Tests which of several routes AiNavigator takes, and what its map stores about them.
#include "firmware/src/nav/Plan.h"
#include "tests/firmware/ai_navigator.h"
#include "tests/firmware/explored.h"
#include "tests/firmware/maps.h"

namespace ai_navigator_ways_test {

using namespace robosim::testing;
using testing::HasSubstr;

/// A ring that is long enough for unequal wheels to mislead dead reckoning.
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

/// The left encoder reports half a percent less distance than the wheel travels.
constexpr const char* kUnequalWheels = R"(
base = "uno5"
remove = ["encoder_left"]

[[part]]
name = "encoder_left"
type = "encoder"
pins = { a = 2 }
periods = 153.6
)";

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

// When the sketch's search is at the second junction, the third junction is farther away than all junctions
// found so far. The search first reaches the third junction by the longer of the two routes to it.
TEST_F(AiNavigatorAgain, GoesStraightThroughARowOfJunctionsWithWaysRound) {
  put_on(kTwoRings);
  scan();
  const Drive way = go_to("3");
  ASSERT_TRUE(way);
  EXPECT_LT(way.distance().mm, 2300.0);
  EXPECT_THAT(way.serial(), HasSubstr("way: junction 1 straight, junction 2 straight, junction 3 straight, "
                                      "junction 5 straight, junction 4 straight, station 3"));
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

TEST_F(AiNavigatorAgain, KnowsTheOtherWaysOfAJunctionAtBothEndsOfALineWithAnObstacle) {
  put_on(kRingOfThree);
  scan();
  robot().act("obstacle 8,6");
  for (const char* station : {"2", "3", "2"}) {
    ASSERT_TRUE(go_to(station)) << station;
    EXPECT_EQ(robot().station(), station);
  }
}

TEST_F(AiNavigatorAgain, SaysThatNoWayRoundLeadsToAStationBehindAnObstacle) {
  put_on(kRingOfThree);
  scan();
  robot().act("obstacle 13,6");
  robot().send("2\n");
  ASSERT_TRUE(robot().run_until(serial_says("no way to 2\r\nat junction 2"), within(1_min)));
  ASSERT_TRUE(go_to("3"));
  EXPECT_EQ(robot().station(), "3");
}

}  // namespace ai_navigator_ways_test
