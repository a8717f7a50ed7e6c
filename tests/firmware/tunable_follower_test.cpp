// Tests TunableFollower: a line follower with a button, a serial port, settings in EEPROM, and safety
// stops.
#include <robosim/testing.h>

#include <regex>

#include "tests/firmware/sketches.h"

namespace tunable_follower_test {

using namespace robosim::testing;

/// Value of millis() at power-on: two seconds later, millis() wraps. On a real chip, millis() begins with 0
/// and wraps after 49.7 days.
constexpr Duration kAlmostWrapped = std::chrono::milliseconds((1LL << 32) - 2000);

Trial trial_on(const std::string& target, Duration clock_start = {}) {
  const std::string folder = test_sketch("TunableFollower");
  return {.sketch = folder, .map = "oval", .target = target, .clock_start = clock_start};
}

class TunableFollower : public RobotTest, public testing::WithParamInterface<std::string> {
 protected:
  explicit TunableFollower(Duration clock_start = {}) : RobotTest(trial_on(GetParam(), clock_start)) {}

  void SetUp() override {
    RobotTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    ASSERT_TRUE(robot().run_until(serial_says("ready"), within(1_s)));
  }
  /// Sends a command, and waits for the answer.
  void tell(const std::string& command, const std::string& answer) {
    robot().send(command + "\n");
    ASSERT_TRUE(robot().run_until(serial_says(answer), within(500_ms))) << "to " << command;
  }
  /// Returns the number after a word of `status`: "speed", "odometer" or "battery".
  long long status(const std::string& word) {
    robot().send("status\n");
    const Drive answer = robot().run_until(serial_says(" mV\r\n"), within(500_ms));
    std::smatch found;
    const std::string text = answer.serial();
    if (!answer || !std::regex_search(text, found, std::regex(word + " (\\d+)"))) return -1;
    return std::stoll(found[1]);
  }
};

INSTANTIATE_TEST_SUITE_P(On, TunableFollower, Targets("host", "avr"), Named());

TEST_P(TunableFollower, StandsUntilItsButtonIsPressedAndStopsWhenItIsPressedAgain) {
  EXPECT_THAT(robot().run_for(500_ms), NeverDrives(at_all()));
  robot().press("start");
  ASSERT_TRUE(robot().run_until(serial_says("driving"), within(100_ms)));
  EXPECT_THAT(robot().run_for(500_ms), Not(SerialSays("stopped")));
  robot().press("start");
  ASSERT_TRUE(robot().run_until(serial_says("stopped: button"), within(100_ms)));
  EXPECT_THAT(robot().run_for(500_ms), AllOf(StopsWithin(200_ms), Not(SerialSays("driving"))));
}

TEST_P(TunableFollower, FollowsTheLine) {
  tell("go", "driving");
  EXPECT_THAT(robot().run_for(6_s), AllOf(Follows(line(), within(20_mm)), Not(SerialSays("stopped"))));
  EXPECT_GT(robot().so_far().distance().mm, 1500.0);
}

TEST_P(TunableFollower, FollowsTheLineAtFullSpeed) {
  tell("speed 255", "ok");
  tell("go", "driving");
  EXPECT_THAT(robot().run_for(4_s), AllOf(Follows(line(), within(30_mm)), Not(SerialSays("stopped"))));
}

TEST_P(TunableFollower, StartsStraightEvenIfItHasStoodBesideTheLineForLong) {
  robot().cover("S5", 3_s);
  robot().run_for(3_s);
  tell("go", "driving");
  EXPECT_THAT(robot().run_for(1_s), Follows(line(), within(8_mm)));
}

TEST_P(TunableFollower, FollowsAtOnceWhenItIsPutDownAfterItWasHeldBesideTheLine) {
  tell("go", "driving");
  robot().run_for(500_ms);
  robot().act("lift for 1500ms");
  for (const char* sensor : {"S1", "S2", "S3", "S4"})
    robot().act("fault " + std::string(sensor) + " stuck 60 for 1500ms");
  robot().act("fault S5 stuck 1000 for 1500ms");
  robot().run_for(1500_ms);
  EXPECT_THAT(robot().run_for(2_s), AllOf(Follows(line(), within(25_mm)), Not(SerialSays("stopped"))));
}

TEST_P(TunableFollower, DrivesForTheTimeThatItIsTold) {
  tell("go 1", "driving");
  ASSERT_TRUE(robot().run_until(serial_says("stopped: time is up"), within(1100_ms)));
  tell("go 66", "driving");
  EXPECT_THAT(robot().run_for(2_s), Not(SerialSays("stopped")));
}

TEST_P(TunableFollower, StopsWhereThereIsNoLine) {
  tell("go", "driving");
  robot().run_for(500_ms);
  for (const char* sensor : {"S1", "S2", "S3", "S4", "S5"})
    robot().act("fault " + std::string(sensor) + " stuck 60");
  ASSERT_TRUE(robot().run_until(serial_says("stopped: no line"), within(400_ms)));
  EXPECT_THAT(robot().run_for(500_ms), StopsWithin(200_ms));
}

/// A line with a gap. At its slowest speed, the robot takes more than a quarter of a second to cross the gap.
constexpr const char* kGap = R"(+++
name = "gap"
cell = "25 mm"

[legend]
3 = "gap"
+++
____________________________________________________________
____________________________________________________________
____________________________________________________________
____________________________________________________________
____________________________________________________________
____________________________________________________________
______......................333.......................______
____________________________________________________________
____________________________________________________________
____________________________________________________________
____________________________________________________________
____________________________________________________________
____________________________________________________________
)";

TEST(TunableFollowerAtAGap, DrivesOverItThoughItIsSlow) {
  Simulation robot({.sketch = test_sketch("TunableFollower"), .map = kGap, .start = "8,6,E"});
  ASSERT_TRUE(robot.run_until(serial_says("ready"), within(1_s)));
  robot.send("speed 60\ngo\n");
  const Drive over = robot.run_for(3500_ms);
  EXPECT_THAT(over, Not(SerialSays("stopped"))) << "the robot sees no line for less than 0.3 s";
  EXPECT_GT(over.distance().mm, 800.0);
}

TEST_P(TunableFollower, StopsBeforeItsBatteryIsEmpty) {
  EXPECT_NEAR(status("battery"), 7400, 450);
  tell("go", "driving");
  robot().run_for(500_ms);
  robot().act("fault power sag 6.2V for 20ms");
  EXPECT_THAT(robot().run_for(500_ms), Not(SerialSays("stopped"))) << "a motor's start is not a low battery";
  robot().act("fault power sag 6.2V");
  ASSERT_TRUE(robot().run_until(serial_says("stopped: battery empty"), within(200_ms)));
}

TEST_P(TunableFollower, KeepsItsSettingsWhenItIsSwitchedOff) {
  tell("speed 100", "ok");
  tell("gain 60", "ok");
  tell("odometer 123456", "ok");
  tell("save", "saved");
  robot().run_for(100_ms);
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("ready"), within(1_s)));
  EXPECT_EQ(status("speed"), 100);
  EXPECT_EQ(status("gain"), 60);
  EXPECT_EQ(status("odometer"), 123456);
}

TEST_P(TunableFollower, ForgetsWhatWasNotSaved) {
  tell("speed 100", "ok");
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("ready"), within(1_s)));
  EXPECT_EQ(status("speed"), 140);
}

TEST_P(TunableFollower, RefusesSettingsOutOfRange) {
  for (const char* wrong :
       {"speed 59", "speed 256", "speed -100", "speed 65636", "gain 9", "gain 201", "speed"})
    tell(wrong, "refused");
  EXPECT_EQ(status("speed"), 140);
  EXPECT_EQ(status("gain"), 80);
}

TEST_P(TunableFollower, DoesNotListenToNoise) {
  tell(std::string(60, 'x'), "unknown");
  tell(std::string(21, '7'), "unknown");
  tell("stopgo", "unknown");
  tell("", "unknown");
  tell("speed 99\r", "ok");
  EXPECT_EQ(status("speed"), 99);
  EXPECT_EQ(status("gain"), 80);
}

TEST_P(TunableFollower, SaysWhatItUnderstands) {
  tell("help", "go [SECONDS], stop, speed 60..255, gain 10..200, calibrate, odometer MM, save, status");
}

TEST_P(TunableFollower, MeasuresItsWay) {
  tell("odometer 70000", "ok");
  tell("go 4", "driving");
  ASSERT_TRUE(robot().run_until(serial_says("stopped: time is up"), within(5_s)));
  robot().run_for(300_ms);
  EXPECT_NEAR(status("odometer"), 70000 + robot().so_far().distance().mm, 60);
}

TEST_P(TunableFollower, AnswersWhileItDrives) {
  tell("go", "driving");
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(status("speed"), 140);
    robot().run_for(100_ms);
  }
  tell("help", "status");
  EXPECT_THAT(robot().run_for(1_s), Follows(line(), within(20_mm)));
}

TEST_P(TunableFollower, CalibratesItsSensors) {
  robot().send("calibrate\n");
  const Drive turning = robot().run_until(serial_says("calibrated"), within(2500_ms));
  ASSERT_TRUE(turning);
  EXPECT_LT(turning.distance().mm, 100.0);
  tell("go", "driving");
  EXPECT_THAT(robot().run_for(2_s), AllOf(Follows(line(), within(25_mm)), Not(SerialSays("ready"))));
}

TEST_P(TunableFollower, BlinksWhileItStandsAndShinesWhileItDrives) {
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(robot().run_until(turns_on("LED"), within(300_ms)));
    ASSERT_TRUE(robot().run_until(turns_off("LED"), within(300_ms)));
  }
  tell("go", "driving");
  robot().run_for(20_ms);
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(robot().is_on("LED"));
    robot().run_for(100_ms);
  }
}

TEST_P(TunableFollower, DoesNotWearItsEepromOut) {
  tell("save", "saved");
  tell("save", "saved");
  robot().run_for(1_s);
  EXPECT_LE(robot().eeprom_writes(), 9u) << "a record has nine bytes";
}

TEST_P(TunableFollower, NoticesADamagedRecord) {
  tell("speed 100", "ok");
  tell("save", "saved");
  robot().run_for(100_ms);
  robot().act("fault eeprom flip 17 5");
  robot().power_off(200_ms);
  ASSERT_TRUE(robot().run_until(serial_says("no settings: mine"), within(1_s)));
  EXPECT_EQ(status("speed"), 140);
}

TEST_P(TunableFollower, LeavesTheChipRoom) {
  if (!robot().on_chip()) GTEST_SKIP() << "requires a chip's memory";
  tell("go", "driving");
  robot().run_for(500_ms);
  tell("help", "status");
  EXPECT_THAT(robot(), UsesAtMost(ram(1200), stack(300), flash(24000), loop_time(30_ms)));
}

class TunableFollowerAfterSevenWeeks : public TunableFollower {
 protected:
  TunableFollowerAfterSevenWeeks() : TunableFollower(kAlmostWrapped) {}
};

INSTANTIATE_TEST_SUITE_P(On, TunableFollowerAfterSevenWeeks, Targets("avr"), Named());

TEST_P(TunableFollowerAfterSevenWeeks, DrivesAndBlinksOnWhenItsClockWraps) {
  robot().run_for(1500_ms);
  ASSERT_TRUE(robot().run_until(turns_on("LED") || turns_off("LED"), within(300_ms)));
  tell("go 2", "driving");
  EXPECT_THAT(robot().run_for(1900_ms), AllOf(Follows(line(), within(20_mm)), Not(SerialSays("stopped"))));
  ASSERT_TRUE(robot().run_until(serial_says("stopped: time is up"), within(200_ms)));
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(robot().run_until(turns_on("LED"), within(300_ms)));
    ASSERT_TRUE(robot().run_until(turns_off("LED"), within(300_ms)));
  }
}

}  // namespace tunable_follower_test
