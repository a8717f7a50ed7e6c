// Tests the stepper motor 28BYJ-48. A turn consists of 4075.77 half steps of 0.08833 degrees.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace stepper_test {

constexpr double kHalfStep = 360.0 / (64.0 * 25792.0 / 405.0);

class Stepper : public testing::Test {
 protected:
  Stepper() : Stepper("") {}
  explicit Stepper(const std::string& keys)
      : bench(
            "[[part]]\nname = \"turret\"\ntype = \"stepper\"\npins = { in1 = 8, in2 = 9, in3 = 10, in4 = 11 "
            "}\n" +
            keys) {}

  /// Switches these coils on and the other coils off, and then waits `ms`. As in a sketch, the pins change
  /// one after another.
  void coils(unsigned in1_to_in4, int ms = 2) {
    for (int i = 0; i < 4; ++i)
      bench.board.output(static_cast<Pin>(8 + i), in1_to_in4 >> (3 - i) & 1,
                         bench.now + i * 5 * kMicrosecond);
    bench.ticks(ms);
  }
  double degrees() const {
    for (const Reading& reading : bench.robot.readings())
      if (reading.part == "turret") return reading.value;
    return -1e9;
  }

  BenchRobot bench;
};

TEST_F(Stepper, TurnsAnEighthOfAPeriodForEachHalfStepAndTwoForAFullOne) {
  coils(0b1000);
  for (int i = 0; i < 16; ++i)
    for (const unsigned on : {0b1100u, 0b0100u, 0b0110u, 0b0010u, 0b0011u, 0b0001u, 0b1001u, 0b1000u})
      coils(on);
  EXPECT_NEAR(degrees(), 128 * kHalfStep, 1e-6);
  coils(0b1100, 4);
  for (int i = 0; i < 16; ++i)
    for (const unsigned on : {0b1001u, 0b0011u, 0b0110u, 0b1100u}) coils(on, 4);
  EXPECT_NEAR(degrees(), kHalfStep, 1e-6) << "the motor has turned back";
}

TEST_F(Stepper, LosesStepsWhereTheyComeTooFast) {
  coils(0b1000);
  for (int i = 0; i < 100; ++i)
    for (const unsigned on : {0b1100u, 0b0110u, 0b0011u, 0b1001u}) coils(on, 1);  // 2000 half steps a second
  EXPECT_LT(degrees(), 0.5 * 800 * kHalfStep);
}

TEST_F(Stepper, TremblesWhereTwoOfItsWiresAreExchanged) {
  coils(0b1000);
  for (int i = 0; i < 50; ++i)  // the Stepper library's order for pins 8, 9, 10, 11
    for (const unsigned on : {0b1010u, 0b0110u, 0b0101u, 0b1001u}) coils(on, 3);
  EXPECT_NEAR(degrees(), 0.0, 8 * kHalfStep);
}

TEST_F(Stepper, HoldsItsPlaceWithoutCurrentAndWhereItIsStuck) {
  coils(0b1000);
  coils(0b0100, 4);
  coils(0b0000, 100);
  EXPECT_NEAR(degrees(), 2 * kHalfStep, 1e-6);
  bench.robot.fault("turret", "stuck", {});
  coils(0b0010, 4);
  EXPECT_NEAR(degrees(), 2 * kHalfStep, 1e-6);
}

}  // namespace stepper_test
}  // namespace robosim::robot
