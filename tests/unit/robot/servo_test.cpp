// Tests servos, including servos that turn continuously and drive wheels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace servo_test {

using testing::HasSubstr;

// Sends a pulse of `us` microseconds, which begins with the current tick. Then sends a low level for the rest
// of `ms` milliseconds.
void pulse(BenchRobot& bench, Pin pin, SimTime us, int ms = 20) {
  bench.board.output(pin, true, bench.now);
  SimTime left = us * kMicrosecond;
  int ticks = 0;
  for (; left >= kTick; left -= kTick, ++ticks) bench.tick();
  bench.board.output(pin, false, bench.now + left);
  for (; ticks < ms; ++ticks) bench.tick();
}

double reading(const BenchRobot& bench, const std::string& part) {
  for (const Reading& reading : bench.robot.readings())
    if (reading.part == part) return reading.value;
  return -1e9;
}

constexpr const char* kPan = R"(
[[part]]
name = "pan"
type = "servo"
pin = 9
)";

TEST(Servo, TurnsToTheAngleThatItsPulsesTell) {
  BenchRobot bench(kPan);
  EXPECT_NEAR(reading(bench, "pan"), 90.0, 1e-9);
  for (const auto& [us, angle] : std::vector<std::pair<SimTime, double>>{
           {544, 0.0}, {2400, 180.0}, {1472, 90.0}, {1000, 44.224}, {450, 0.0}, {2600, 180.0}}) {
    for (int i = 0; i < 30; ++i) pulse(bench, 9, us);
    EXPECT_NEAR(reading(bench, "pan"), angle, 0.01) << us;
  }
}

TEST(Servo, FollowsPwmOfATimerWhosePulsesAreOfItsKind) {
  BenchRobot bench(kPan);
  const auto pwm = [&](std::uint32_t period_us, double pulse_us) {
    PinDrive drive;
    drive.mode = PinMode::output;
    drive.pwm = true;
    drive.duty = pulse_us / period_us;
    drive.period_us = period_us;
    bench.board.set_drive(9, drive, bench.now);
    bench.ticks(400);
  };
  pwm(20000, 2400);
  EXPECT_NEAR(reading(bench, "pan"), 180.0, 0.01);
  pwm(20000, 544);
  EXPECT_NEAR(reading(bench, "pan"), 0.0, 0.01);
  pwm(2040, 100);
  EXPECT_NEAR(reading(bench, "pan"), 0.0, 0.01) << "100 us are too short for a servo's pulse";
}

TEST(Servo, TakesItsTimeToGetThere) {
  BenchRobot bench(kPan);
  pulse(bench, 9, 2400, 3);  // the pulse ends after 2.4 ms
  const double before = reading(bench, "pan");
  EXPECT_NEAR(before, 90.0 + 0.5 * 0.6, 1e-6) << "the servo turns by 500 degrees a second";
  bench.ticks(120);
  EXPECT_NEAR(reading(bench, "pan") - before, 60.0, 1e-6);
}

TEST(Servo, StaysWhereItIsWithoutPulsesAndWithOnesThatAreNone) {
  BenchRobot bench(kPan);
  pulse(bench, 9, 250);
  pulse(bench, 9, 4000);
  bench.board.pwm(9, 0.5, bench.now);
  bench.ticks(300);
  EXPECT_NEAR(reading(bench, "pan"), 90.0, 1e-9);
  bench.board.input(9, false, bench.now);
  pulse(bench, 9, 1477);
  EXPECT_NEAR(reading(bench, "pan"), 90.485, 0.01);
  pulse(bench, 9, 1470);
  EXPECT_NEAR(reading(bench, "pan"), 90.485, 0.01) << "within the dead band";
}

TEST(Servo, StaysWhereItIsWhenItIsStuck) {
  BenchRobot bench(kPan);
  pulse(bench, 9, 2400, 63);
  bench.robot.fault("pan", "stuck", {});
  const double at = reading(bench, "pan");
  EXPECT_GT(at, 110.0);
  bench.ticks(500);
  EXPECT_EQ(reading(bench, "pan"), at);
}

constexpr const char* kWheels = R"(
[[part]]
name = "left"
type = "wheel-servo"
pin = 9
[[part]]
name = "right"
type = "wheel-servo"
pin = 10
dead_band = "0 us"
full = "200 us"
)";

// Sends a pulse to the left servo, and 10 ms later a pulse to the right servo. Repeats this every 20 ms.
void both(BenchRobot& bench, SimTime left_us, SimTime right_us, int times = 1) {
  for (int i = 0; i < times; ++i) {
    pulse(bench, 9, left_us, 10);
    pulse(bench, 10, right_us, 10);
  }
}

TEST(WheelServo, TurnsFasterTheMoreItsPulsesDifferFromThoseForStandingStill) {
  BenchRobot bench(kWheels);
  both(bench, 1500, 1500);
  EXPECT_EQ(bench.robot.left_command(), 0.0);
  EXPECT_EQ(bench.robot.right_command(), 0.0);
  both(bench, 2000, 1300);
  EXPECT_EQ(bench.robot.left_command(), 1.0);
  EXPECT_EQ(bench.robot.right_command(), 1.0) << "the right servo is mounted the other way round";
  both(bench, 1000, 1700);
  EXPECT_EQ(bench.robot.left_command(), -1.0);
  EXPECT_EQ(bench.robot.right_command(), -1.0);
  both(bench, 1500 + 45 + 91, 1400);
  EXPECT_NEAR(bench.robot.left_command(), 0.2, 1e-9);
  EXPECT_NEAR(bench.robot.right_command(), 0.5, 1e-9);
  both(bench, 1540, 1472);
  EXPECT_EQ(bench.robot.left_command(), 0.0) << "within the dead band";
  EXPECT_NEAR(bench.robot.right_command(), 0.14, 1e-9)
      << "Servo.write(90) sends 1472 us, so the servo creeps";
}

TEST(WheelServo, DrivesTheRobot) {
  BenchRobot bench(kWheels);
  both(bench, 2000, 1300, 10);
  EXPECT_GT(bench.body().speed(), 0.5);
  both(bench, 1500, 1500, 20);
  EXPECT_NEAR(bench.body().speed(), 0.0, 1e-3) << "a servo commanded to stop brakes";
}

TEST(WheelServo, RollsOutWhenThePulsesEnd) {
  BenchRobot bench(kWheels);
  both(bench, 2000, 1300, 3);
  bench.ticks(28);
  EXPECT_EQ(bench.robot.left_command(), 1.0);
  bench.ticks(30);
  EXPECT_EQ(bench.robot.left_command(), 0.0);
  EXPECT_EQ(bench.robot.right_command(), 0.0);
}

TEST(WheelServo, HasAMotorsFaults) {
  BenchRobot bench(kWheels);
  bench.robot.fault("left", "reversed", {});
  both(bench, 2000, 1300);
  EXPECT_EQ(bench.robot.left_command(), -1.0);
  bench.robot.fault("left", "weak", {"50%"});
  bench.tick();
  EXPECT_EQ(bench.robot.left_command(), 0.5);
}

TEST(Servo, ThatSomethingSitsOnMustExist) {
  try {
    BenchRobot bench(std::string(kPan) + R"(
[[part]]
name = "sonar"
type = "hc-sr04"
pins = { trig = 2, echo = 3 }
on = "tilt"
)");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("on: unknown servo: expected pan, got “tilt”"));
  }
}

}  // namespace servo_test
}  // namespace robosim::robot
