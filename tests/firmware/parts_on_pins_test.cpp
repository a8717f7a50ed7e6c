// Tests sketches that use robots' parts through plain pins, on every target.
#include <robosim/testing.h>

#include "tests/firmware/sketches.h"

namespace parts_on_pins_test {

using namespace robosim::testing;

class OnPins : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(On, OnPins, AllTargets(), Named());

constexpr const char* kRoom = R"(+++
name = "room"
+++
########################
#______________________#
#______________________#
#______________________#
#______________________#
#__S._________________##
#______________________#
#______________________#
#______________________#
#______________________#
#______________________#
########################
)";

// uno3 without its line sensors, with a distance sensor on a servo in front.
constexpr const char* kLooksAround = R"(
base = "uno3"
remove = ["left_sensor", "middle_sensor", "right_sensor", "start", "bumper", "buzzer", "LED", "LED2"]

[[part]]
name = "pan"
type = "servo"
pin = 11
at = ["60 mm", "0 mm"]

[[part]]
name = "sonar"
type = "hc-sr04"
pins = { trig = 12, echo = 13 }
at = ["15 mm", "0 mm"]
on = "pan"
)";

TEST_P(OnPins, ARobotWithASonarOnAServoDrivesAboutARoomAndTouchesNothing) {
  Simulation robot(
      {.sketch = test_sketch("LooksAround"), .map = kRoom, .robot = kLooksAround, .target = GetParam()});
  ASSERT_TRUE(robot.run_until(serial_matches("ahead 17[78]"), within(2_s)));
  const Drive drive = robot.run_for(20_s);
  EXPECT_THAT(drive, NeverCollides());
  EXPECT_GT(drive.distance().mm, 2000);
  EXPECT_THAT(drive, SerialMatches("left \\d+ right \\d+"));
  EXPECT_NEAR(robot.reading("pan"), 90, 80) << "the servo's angle in degrees";
}

TEST_P(OnPins, ASonarSeesAnObstacleThatIsPutInTheWay) {
  Simulation robot(
      {.sketch = test_sketch("LooksAround"), .map = kRoom, .robot = kLooksAround, .target = GetParam()});
  ASSERT_TRUE(robot.run_until(serial_says("ahead"), within(2_s)));
  EXPECT_NEAR(robot.reading("sonar"), 177.5, 1);
  robot.act("obstacle 10,5 radius 60mm");
  const Drive drive = robot.run_until(serial_says("left"), within(5_s));
  ASSERT_TRUE(drive);
  EXPECT_THAT(drive, NeverCollides());
  const double before_it = 1050 - 60 - 75;  // x in mm at which the sensor's front touches the obstacle
  EXPECT_GT(robot.pose().x_mm, before_it - 250) << "the robot stops at a distance of 25 cm";
  EXPECT_LT(robot.pose().x_mm, before_it) << "the robot coasts, but does not touch the obstacle";
}

constexpr const char* kPanel = R"(
base = "uno5"
remove = ["S", "left", "right", "encoder_left", "encoder_right", "start", "bumper", "buzzer", "LED", "LED2"]

[[part]]
name = "pad"
type = "keypad"
rows = [6, 7, 8, 9]
columns = [10, "A0", "A1"]

[[part]]
name = "lcd"
type = "lcd"
pins = { rs = 12, en = 11, d4 = 5, d5 = 4, d6 = 3, d7 = 2 }

[[part]]
name = "ir"
type = "ir-receiver"
pin = "A2"

[[part]]
name = "bt"
type = "bluetooth"
pins = { txd = 0, rxd = 1 }

[[part]]
name = "buzzer"
type = "buzzer"
pin = 13
)";

TEST_P(OnPins, KeypadRemoteAndPhoneChooseWhatTheDisplayShows) {
  Simulation robot({.sketch = test_sketch("Panel"),
                    .map = kRoom,
                    .robot = kPanel,
                    .target = GetParam(),
                    .script = "after lcd \"Choose\" press pad.5 50ms\n"
                              "after lcd \"key\" wait 100ms send ir 69 for 250ms\n"
                              "after lcd \"remote\" wait 100ms send bt \"7\"\n"});
  ASSERT_TRUE(robot.run_until(tells("lcd", "key 5"), within(2_s)));
  EXPECT_NEAR(robot.reading("buzzer"), 1000, 10);
  ASSERT_TRUE(robot.run_until(tells("lcd", "remote 69"), within(1_s)));
  ASSERT_TRUE(robot.run_until(tells("lcd", "phone 7"), within(1_s)));
  EXPECT_THAT(robot, SerialSays("phone 7"));
}

constexpr const char* kPhone = R"(
base = "uno5"
remove = ["encoder_left", "encoder_right"]

[[part]]
name = "bt"
type = "bluetooth"
pins = { txd = 2, rxd = 3 }
)";

// The test uses the SoftwareSerial library of the AVR core.
TEST(SoftwareSerialOnAvr, APhoneDrivesARobot) {
  ROBOSIM_SKIP_WITHOUT("avr");
  Simulation robot({.sketch = test_sketch("PhoneDrives"), .map = "oval", .robot = kPhone, .target = "avr"});
  ASSERT_TRUE(robot.run_until(tells("bt", "ready"), within(500_ms)));
  robot.act("send bt \"f\"");
  ASSERT_TRUE(robot.run_until(tells("bt", "forward"), within(200_ms)));
  EXPECT_THAT(robot.run_for(300_ms), NeverDrives(backwards()));
  EXPECT_GT(robot.moment().speed.mm_per_s, 100);
  robot.act("send bt \"x\"");
  ASSERT_TRUE(robot.run_until(tells("bt", "what?"), within(200_ms)));
  robot.act("send bt \"s\"");
  ASSERT_TRUE(robot.run_until(tells("bt", "stop"), within(200_ms)));
}

constexpr const char* kServoWheels = R"(
base = "uno2"
remove = ["left", "right", "buzzer", "LED", "LED2"]

[chassis]
wheel = "60 mm"
mass = "300 g"

[motors]
voltage = "6 V"
supply = "6 V"
no_load = "130 rpm"
no_load_current = "120 mA"
stall_torque = "1.5 kg cm"
stall_current = "800 mA"
gear = 300
rotor_inertia = "0.01 g cm2"

[driver]
chip = "servo"

[[part]]
name = "left_wheel"
type = "wheel-servo"
pin = 9

[[part]]
name = "right_wheel"
type = "wheel-servo"
pin = 10
)";

TEST_P(OnPins, ARobotOnServosFollowsALine) {
  Simulation robot({.sketch = test_sketch("ServoWheels"),
                    .map = "oval",
                    .robot = kServoWheels,
                    .target = GetParam(),
                    .goal = "laps:1"});
  EXPECT_THAT(robot.run_to_the_end(), Reaches("laps:1"));
}

}  // namespace parts_on_pins_test
