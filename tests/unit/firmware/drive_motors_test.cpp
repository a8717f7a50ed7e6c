#include "DriveMotors.h"

#include <gtest/gtest.h>

namespace drive_motors_test {

constexpr std::uint8_t kEnable = 5, kIn1 = 7, kIn2 = 8;

class DriveMotorTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fake::board = fake::Board{};
    motor.begin();
  }

  static fake::Pin& pin(std::uint8_t number) { return fake::board.pins[number]; }
  static void expect(int in1, int in2, int duty) {
    EXPECT_EQ(pin(kIn1).level, in1);
    EXPECT_EQ(pin(kIn2).level, in2);
    EXPECT_EQ(pin(kEnable).duty, duty);
  }

  DriveMotor motor{kEnable, kIn1, kIn2};
};

TEST_F(DriveMotorTest, BeginsWithTheMotorOff) {
  for (const std::uint8_t number : {kEnable, kIn1, kIn2}) {
    EXPECT_EQ(pin(number).mode, OUTPUT);
    EXPECT_EQ(pin(number).level, LOW);
    EXPECT_EQ(pin(number).duty, -1);
  }
}

TEST_F(DriveMotorTest, SetsDirectionByTheInputsAndSpeedByTheEnablePin) {
  motor.drive(100);
  expect(HIGH, LOW, 100);
  motor.drive(-200);
  expect(LOW, HIGH, 200);
}

TEST_F(DriveMotorTest, BrakesAtSpeedZero) {
  motor.drive(0);
  expect(HIGH, HIGH, 255);
}

TEST_F(DriveMotorTest, CutsOffWhatIsTooFast) {
  motor.drive(300);
  expect(HIGH, LOW, 255);
  motor.drive(-32768);
  expect(LOW, HIGH, 255);
}

TEST_F(DriveMotorTest, TurnsTheOtherWayWhenReversed) {
  motor.setReversed(true);
  motor.drive(100);
  expect(LOW, HIGH, 100);
  motor.drive(-32768);
  expect(HIGH, LOW, 255);
}

TEST_F(DriveMotorTest, RunsOutWhenCoasting) {
  motor.drive(100);
  motor.coast();
  EXPECT_EQ(pin(kEnable).level, LOW);
  EXPECT_EQ(pin(kEnable).duty, -1);
}

TEST_F(DriveMotorTest, StartsAtTheSmallestDutyThatTurnsTheMotor) {
  EXPECT_EQ(DriveMotor::dutyFor(0, 60), 0);
  EXPECT_EQ(DriveMotor::dutyFor(1, 60), 60);
  EXPECT_EQ(DriveMotor::dutyFor(128, 60), 157);
  EXPECT_EQ(DriveMotor::dutyFor(255, 60), 255);
  motor.setSmallestDuty(60);
  motor.drive(-128);
  expect(LOW, HIGH, 157);
}

TEST_F(DriveMotorTest, PutsThePwmOnTheInputsOfADriverWithoutEnablePin) {
  DriveMotor two(9, 10);
  two.begin();
  two.drive(80);
  EXPECT_EQ(pin(9).duty, 80);
  EXPECT_EQ(pin(10).duty, 0);
  two.drive(-90);
  EXPECT_EQ(pin(9).duty, 0);
  EXPECT_EQ(pin(10).duty, 90);
  two.drive(0);
  EXPECT_EQ(pin(9).duty, 255);
  EXPECT_EQ(pin(10).duty, 255);
}

TEST_F(DriveMotorTest, WakesTheDriver) {
  DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10), 3);
  motors.begin();
  EXPECT_EQ(pin(3).mode, OUTPUT);
  EXPECT_EQ(pin(3).level, HIGH);
  motors.drive(50, -60);
  EXPECT_EQ(pin(5).duty, 50);
  EXPECT_EQ(pin(6).duty, 60);
  EXPECT_EQ(pin(10).level, HIGH);
}

TEST_F(DriveMotorTest, OfAPairAreToldTogether) {
  DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
  motors.begin();
  motors.drive(100, 100);
  motors.stop();
  for (const std::uint8_t input : {7, 8, 9, 10}) EXPECT_EQ(pin(input).level, HIGH) << "both motors brake";
  motors.drive(100, 100);
  motors.coast();
  for (const std::uint8_t enable : {5, 6}) EXPECT_EQ(pin(enable).duty, -1) << "both motors coast";
  motors.setSmallestDuty(60);
  motors.setReversed(false, true);
  motors.drive(128, 128);
  EXPECT_EQ(pin(5).duty, 157);
  EXPECT_EQ(pin(6).duty, 157);
  EXPECT_EQ(pin(7).level, HIGH);
  EXPECT_EQ(pin(9).level, LOW);
  motors.setReversed(true, false);
  motors.drive(128, 128);
  EXPECT_EQ(pin(7).level, LOW);
  EXPECT_EQ(pin(9).level, HIGH);
}

}  // namespace drive_motors_test
