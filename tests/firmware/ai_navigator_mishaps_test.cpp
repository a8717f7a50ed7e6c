// Tests AiNavigator in changed situations: the robot is carried away, an obstacle stays, or the power fails.
#include <chrono>

#include "tests/firmware/ai_navigator.h"
#include "tests/firmware/maps.h"

namespace ai_navigator_mishaps_test {

using namespace robosim::testing;

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

// After power-on at station 3, the robot's heading 0 differs from the map's heading 0.
TEST_F(AiNavigatorAgain, DrivesOverTwoJunctionsAfterItWasSwitchedOffFacingAnotherWay) {
  put_on(kRingOfThree);
  scan();
  ASSERT_TRUE(go_to("3"));
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("I have a map: 3 stations, 2 junctions"), within(2_s)));
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
  EXPECT_THAT(robot().run_for(1_s), AllOf(NeverDrives(at_all()), Not(SerialSays("going to"))));
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
  ASSERT_TRUE(wait) << "the robot waits for 4 s";
  EXPECT_GT(wait.end() - wait.begin(), 3500_ms);
  ASSERT_TRUE(robot().run_until(serial_says("no way to 3"), within(1_min)));
  robot().act("clear 8,3");
  ASSERT_TRUE(go_to("2"));
  EXPECT_EQ(robot().station(), "2");
}

TEST_F(AiNavigatorAgain, ScansFromAJunctionOrTheMiddleOfALine) {
  for (const char* start : {"6,3,E", "6,3,S", "8,3,W"}) {
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
  EXPECT_NEAR(robot().reading("buzzer"), 1760, 2) << "beeps for 100 ms: the scan is complete";
  robot().run_for(40_ms);
  EXPECT_EQ(robot().reading("buzzer"), 0);
  robot().send("9\n");
  robot().run_for(780_ms);
  EXPECT_NEAR(robot().reading("buzzer"), 440, 2) << "beeps for 800 ms: the station does not exist";
  robot().run_for(40_ms);
  EXPECT_EQ(robot().reading("buzzer"), 0);
  robot().send("2\n");
  ASSERT_TRUE(robot().run_until(serial_says("arrived at 2"), within(1_min)));
  robot().run_for(80_ms);
  EXPECT_NEAR(robot().reading("buzzer"), 1760, 2) << "beeps for 100 ms: the robot has arrived";
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

}  // namespace ai_navigator_mishaps_test
