// Tests robots whose front wheels a servo steers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/error.h"
#include "sim/robot/describe.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace steering_test {

using testing::HasSubstr;

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kTwoPercent = 0.02;
constexpr Pin kServo = 9, kForward = 6;

const std::string kDrive =
    "[[part]]\nname = \"motor\"\ntype = \"motor\"\nwheel = \"both\"\npins = { in1 = 6, in2 = 7 }\n";
const std::string kFront = "[[part]]\nname = \"front\"\ntype = \"servo\"\npin = 9\nspeed = \"100 deg/s\"\n";

std::string car(const std::string& keys, const std::string& parts = kDrive + kFront) {
  std::string robot = kBareRobot;
  robot.insert(robot.find("[motors]"), keys + "\n");
  return robot + parts;
}

std::string steering(const std::string& more = "") {
  return "load_share = 0.5\nsteering = { servo = \"front\", base = \"100 mm\"" + more + " }";
}

// Makes the board repeat the pulse that the Servo library sends for this angle.
void hold(BenchRobot& bench, double degrees) {
  PinDrive drive;
  drive.mode = PinMode::output;
  drive.pwm = true;
  drive.period_us = 20000;
  drive.duty = (544.0 + degrees / 180.0 * 1856.0) / 20000.0;
  bench.board.set_drive(kServo, drive, bench.now);
}

TEST(Steering, DrivesOnTheRadiusThatItsServoSays) {
  BenchRobot bench(parse_description(car(steering()), "car.toml"));
  const world::Body& body = bench.body();
  for (const double degrees : {20.0, -10.0}) {
    bench.board.output(kForward, false, bench.now);
    hold(bench, 90.0 + degrees);
    bench.ticks(1000);
    bench.body().place({bench.line(), {1.0, 0.0}});
    bench.board.pwm(kForward, 0.3, bench.now);
    bench.ticks(150);
    EXPECT_GT(body.speed(), 0.02);
    const double expected = std::tan(degrees * kDegree) / 0.1;
    EXPECT_NEAR(body.turn_rate() / body.speed(), expected, kTwoPercent * std::fabs(expected));
  }
}

TEST(Steering, IsToldWithWhatADrawingNeeds) {
  EXPECT_FALSE(describe(parse_description(kBareRobot, "bare.toml")).steered);
  const std::string reversed = kFront + "reversed = true\n";
  const auto car_of = [&](const std::string& more, const std::string& front) {
    return describe(parse_description(car(steering(more), kDrive + front), "car.toml")).steered.value();
  };
  const SteeredWheels one = car_of(", limit = \"25 deg\", ratio = 0.5", kFront);
  EXPECT_EQ(one.servo, "front");
  EXPECT_EQ(one.wheels, 1);
  EXPECT_NEAR(one.middle, 90.0 * kDegree, 1e-9);
  EXPECT_NEAR(one.ratio, 0.5, 1e-9);
  EXPECT_NEAR(one.limit, 25.0 * kDegree, 1e-9);
  const SteeredWheels two = car_of(", limit = \"25 deg\", wheels = 2", reversed);
  EXPECT_EQ(two.wheels, 2);
  EXPECT_NEAR(two.ratio, -1.0, 1e-9) << "longer pulses steer to the right";
  EXPECT_LT(two.limit, one.limit) << "the limit applies to the inner wheel";
}

TEST(Steering, TurnsAsFastAsItsServoUpToItsLimit) {
  BenchRobot bench(parse_description(car(steering(", limit = \"25 deg\", ratio = 0.5")), "car.toml"));
  hold(bench, 170.0);
  bench.ticks(200);
  EXPECT_NEAR(bench.body().steered(), 10.0 * kDegree, 0.1 * kDegree);  // 0.2 s * 100 deg/s * ratio
  bench.ticks(800);
  EXPECT_NEAR(bench.body().steered(), 25.0 * kDegree, 1e-9);
}

TEST(Steering, ACarsLimitIsThatOfItsInnerWheel) {
  BenchRobot bench(parse_description(car(steering(", limit = \"30 deg\", wheels = 2")), "car.toml"));
  hold(bench, 0.0);
  bench.ticks(2000);
  const double radius = 0.1 / std::tan(30.0 * kDegree) + 0.05;
  EXPECT_NEAR(std::tan(bench.body().steered()), -0.1 / radius, 1e-6);
}

TEST(Steering, OneMotorForBothWheelsIsHalfOnEach) {
  const Description one = parse_description(car(steering()), "car.toml");
  const world::BodyParams params = body_params(one, 1, Profile::ideal);
  const world::BodyParams bare = body_params(parse_description(kBareRobot, "r.toml"), 1, Profile::ideal);
  EXPECT_TRUE(params.differential);
  for (const world::Side side : {world::left, world::right}) {
    EXPECT_DOUBLE_EQ(params.wheel[side].stall_torque, 0.5 * bare.wheel[side].stall_torque);
    EXPECT_DOUBLE_EQ(params.wheel[side].stall_current, 0.5 * bare.wheel[side].stall_current);
  }
}

TEST(Steering, BadValuesGetOneSentence) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parse_description(text, "car.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "no message";
  };
  const std::string both_and_left =
      kDrive + kFront + "[[part]]\nname = \"left\"\ntype = \"motor\"\npins = { in1 = 2, in2 = 3 }\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {car("steering = 3"), "steering"},
      {car("steering = { base = \"100 mm\" }"), "servo"},
      {car("steering = { servo = \"front\" }"), "base"},
      {car("steering = { servo = \"\", base = \"100 mm\" }"), "servo: unknown servo: expected"},
      {car("steering = { servo = \"rear\", base = \"100 mm\" }"),
       "servo: unknown servo: expected front, got “rear”"},
      {car("steering = { servo = \"motor\", base = \"100 mm\" }", kDrive),
       "unknown servo “motor”: the robot has none"},
      {car("steering = { servo = \"front\", base = \"1 mm\" }"), "base: expected"},
      {car(steering(", limit = \"90 deg\"")), "limit: expected"},
      {car(steering(", ratio = 0")), "ratio: expected"},
      {car(steering(", wheels = 3")), "wheels: expected a whole number from 1 to 2, got 3"},
      {car("load_share = 1\nsteering = { servo = \"front\", base = \"100 mm\" }"),
       "load_share: expected 0.05 to 0.95, got 1"},
      {car(steering(", play = 3")), "unknown key play"},
      {car(steering() + "\nwheelbase = \"100 mm\""), "wheelbase requires a robot without steered wheels"},
      {car(steering() + "\ntracks = \"100 mm\""), "tracks requires a robot without steered wheels"},
      {car(steering() + "\ncaster = \"50 mm\""), "caster requires a robot without steered wheels"},
      {car(""), "motor motor drives both wheels through a differential"},
      {car(steering(), both_and_left), "motors motor and left drive the same wheel"},
  };
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
  EXPECT_EQ(message(car(steering())), "no message");
}

}  // namespace steering_test
}  // namespace robosim::robot
