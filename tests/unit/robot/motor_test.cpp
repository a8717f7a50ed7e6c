// Tests motor drivers and motors: PWM, braking, coasting and energy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "sim/base/error.h"
#include "sim/robot/parts/motor_driver.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace motor_test {

constexpr const char* kMotors = R"(
[[part]]
name = "left"
type = "motor"
pins = { en = 5, in1 = 7, in2 = 8 }
[[part]]
name = "right"
type = "motor"
pins = { en = 6, in1 = 9, in2 = 10 }
)";

const DriverChip& chip(const std::string& name) {
  for (const DriverChip& chip : driver_chips())
    if (chip.name == name) return chip;
  throw InputError(name);
}

void expect_command(const world::WheelCommand& command, double drive, double brake) {
  EXPECT_NEAR(command.drive, drive, 1e-12);
  EXPECT_NEAR(command.brake, brake, 1e-12);
}

std::string refusal(const std::string& from, const std::string& to) {
  std::string text = kBareRobot;
  text.replace(text.find(from), from.size(), to);
  try {
    parse_description(text, "bench.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(MotorDriver, WindingsAndDiodesThatMakeNoSenseAreRefused) {
  using testing::HasSubstr;
  const std::string supply = "supply = \"6 V\"", chip = "chip = \"tb6612\"";
  EXPECT_THAT(refusal(supply, supply + "\ninductance = \"200 mH\""),
              HasSubstr("bench.toml:14:14: inductance: expected 0 to 100 mH"));
  EXPECT_THAT(refusal(supply, supply + "\ninductance = \"-1 uH\""), HasSubstr("inductance: expected "));
  EXPECT_THAT(refusal(supply, supply + "\ninductance = \"1 ohm\""),
              HasSubstr("inductance: expected a number with a unit (uH, mH or H), got \"1 ohm\""));
  EXPECT_THAT(refusal(supply, supply + "\ninductance = 1"), HasSubstr("inductance"));
  EXPECT_THAT(refusal(supply, supply + "\ninductance = { value = \"1 mH\", spread = \"2 mH\" }"),
              HasSubstr("inductance"));
  EXPECT_THAT(refusal(chip, chip + "\ndiode = \"-1 V\""), HasSubstr("diode: expected 0 to 10 V, got -1 V"));
  EXPECT_THAT(refusal(chip, chip + "\ndiode = \"11 V\""), HasSubstr("diode: expected 0 to 10 V, got 11 V"));
  EXPECT_THAT(refusal(chip, chip + "\ndiode = \"1 A\""),
              HasSubstr("diode: expected a number with a unit (mV or V), got \"1 A\""));
  EXPECT_THAT(refusal(chip, chip + "\ndiodes = \"1 V\""), HasSubstr("diodes"));
}

TEST(MotorDriver, TellsHowMuchOfAPeriodIsDrivenAgainstTheRest) {
  const world::WheelCommand command = bridge_command(chip("drv8835"), {1, 0.7, 0, true, 1e-3});
  expect_command(command, 0.4, 0.6);
  EXPECT_NEAR(command.against, 0.3, 1e-12);
  EXPECT_EQ(command.period_s, 1e-3);
}

// Drives at full speed, and then with fast PWM of 30 %. Measures the share of the speed that remains after
// 100 ms, and the energy that returns to the battery.
TEST(MotorDriver, DecidesWhatBecomesOfAWindingsCurrent) {
  const auto slowed = [](const char* driver, double en, double in1, double in2) {
    std::string robot = kBareRobot;
    robot.replace(robot.find("tb6612"), 6, driver);
    robot.replace(robot.find("supply"), 6, "inductance = \"0.5 mH\"\nsupply");
    BenchRobot bench(parse_description(robot + kMotors, "bench.toml"));
    const auto drive = [&](Pin pin, double duty) {
      PinDrive told{PinMode::output, duty >= 1.0, duty > 0.0 && duty < 1.0, duty};
      told.period_us = 50;
      bench.board.set_drive(pin, told, bench.now);
    };
    for (const bool left : {true, false}) {
      drive(left ? 5 : 6, 1.0);
      drive(left ? 7 : 9, 1.0);
      drive(left ? 8 : 10, 0.0);
    }
    bench.ticks(500);
    const double speed = bench.body().speed();
    for (const bool left : {true, false}) {
      drive(left ? 5 : 6, en);
      drive(left ? 7 : 9, in1);
      drive(left ? 8 : 10, in2);
    }
    bench.ticks(100);
    return std::pair(bench.body().speed() / speed, bench.body().energy_back());
  };
  // With slow decay, PWM of 30 % slows the robot, and returns energy to the battery. The pulses are on EN, or
  // on one input while the other input is high.
  for (const auto& [left, back] :
       {slowed("tb6612", 0.3, 1, 0), slowed("drv8833", 1, 1, 0.7), slowed("drv8835", 0.3, 1, 0)}) {
    EXPECT_LT(left, 0.6);
    EXPECT_GT(back, 0.005);
  }
  // With fast decay, the robot rolls on. Between the pulses, the diodes stop the current, so the motor does
  // not brake.
  for (const auto& [left, back] : {slowed("l298n", 0.3, 1, 0), slowed("drv8833", 1, 0.3, 0)}) {
    EXPECT_GT(left, 0.8);
    EXPECT_LT(back, 1e-4);
  }
  // If both inputs are equal, the motor is shorted (this loop) or open (the next loop).
  for (const auto& [left, back] : {slowed("l298n", 1, 1, 1), slowed("l298n", 1, 0, 0),
                                   slowed("tb6612", 1, 1, 1), slowed("drv8833", 1, 1, 1)}) {
    EXPECT_LT(left, 0.5);
    EXPECT_EQ(back, 0.0);
  }
  for (const auto& [left, back] :
       {slowed("l298n", 0, 1, 1), slowed("tb6612", 1, 0, 0), slowed("drv8833", 1, 0, 0)}) {
    EXPECT_GT(left, 0.8);
    EXPECT_EQ(back, 0.0);
  }
}

// The robot of mass m drives ahead at full speed v, without friction. If a motor is reversed, the supply and
// the motor's own voltage both drive the current. Until the robot is equally fast backward, the battery
// supplies the charge for the momentum change 2 m v. If the motors are shorted, the robot slows down until
// the driver's voltage drop stops the current. If the motors are open, the robot rolls on.
TEST(MotorDriver, ReversedTakesTwiceTheStallCurrentAndBrakedOrOpenNone) {
  constexpr double kWithin = 0.02, kVolts = 6.0, kBrakes_s = 0.1;
  for (const char* const name : {"l298n", "l293d", "tb6612", "drv8833", "drv8835"}) {
    for (const bool wound : {false, true}) {
      SCOPED_TRACE(std::string(name) + (wound ? ", wound" : ""));
      std::string robot = kBareRobot;
      robot.replace(robot.find("tb6612"), 6, name);
      robot.replace(robot.find("300 g\""), 6, "3 kg\"\ngrip = 3\nrolling = 0");
      if (wound) robot.replace(robot.find("supply"), 6, "inductance = \"0.5 mH\"\nsupply");
      const auto at_full_speed = [&] {
        auto bench = std::make_unique<BenchRobot>(parse_description(robot + kMotors, "bench.toml"),
                                                  Profile::ideal, 1, "+++\ncell = \"2 m\"\n+++\n");
        for (const Pin pin : {5, 6, 7, 9}) bench->board.output(pin, true, 0);
        for (const Pin pin : {8, 10}) bench->board.output(pin, false, 0);
        bench->ticks(3000);
        return bench;
      };
      const auto inputs = [](BenchRobot& bench, bool en, bool in1, bool in2) {
        const std::pair<Pin, bool> levels[] = {{5, en}, {6, en}, {7, in1}, {9, in1}, {8, in2}, {10, in2}};
        for (const auto& [pin, level] : levels) bench.board.output(pin, level, bench.now);
      };
      const DriverChip& driver = chip(name);
      const auto bench = at_full_speed();
      world::Body& body = bench->body();
      const world::WheelParams& w = body.params().wheel[world::left];
      const double full = body.speed(), mass = 2.0 * body.kinetic_energy() / (full * full);
      const double ke = w.nominal_volts / w.no_load_rate / w.radius_m;  // in V per m/s
      const double kt = w.stall_torque / w.stall_current / w.radius_m;  // in N per A
      const double ohms = w.nominal_volts / w.stall_current + driver.resistance;
      EXPECT_NEAR(ke * full, kVolts - driver.drop, kWithin * kVolts);

      const double taken = body.energy();
      inputs(*bench, true, false, true);
      bench->tick();
      const double most = 2.0 * 2.0 * (kVolts - driver.drop) / ohms;
      EXPECT_NEAR(body.draw(kVolts).amps, most, kWithin * most);
      bench->ticks(3000);
      EXPECT_NEAR(body.speed(), -full, kWithin * full);
      const double brakes = wound ? std::max(ke, kt) : kt;  // braking force in N per A
      const double reversal = kVolts * mass * full * (1.0 / brakes + 1.0 / kt);
      EXPECT_NEAR(body.energy() - taken, reversal, kWithin * reversal);
      EXPECT_EQ(body.energy_back(), 0.0);

      for (const bool shorted : {true, false}) {
        const auto again = at_full_speed();
        const double drawn = again->body().energy();
        inputs(*again, shorted, shorted, shorted);
        again->ticks(static_cast<int>(1000.0 * kBrakes_s));
        const double stops = driver.drop / ke, tau = mass * ohms / (2.0 * ke * brakes);
        const double left = shorted ? stops + (full - stops) * std::exp(-kBrakes_s / tau) : full;
        EXPECT_NEAR(again->body().speed(), left, kWithin * full) << shorted;
        EXPECT_EQ(again->body().energy(), drawn) << shorted;
      }
    }
  }
}

TEST(MotorDriver, L298nCoastsBetweenPulsesOnEnable) {
  expect_command(bridge_command(chip("l298n"), {0.3, 1, 0}), 0.3, 0.0);
  expect_command(bridge_command(chip("l298n"), {0.3, 0, 1}), -0.3, 0.0);
}

TEST(MotorDriver, L298nBrakesWhenBothInputsAreAlikeAndEnableIsHigh) {
  expect_command(bridge_command(chip("l298n"), {1, 1, 1}), 0.0, 1.0);
  expect_command(bridge_command(chip("l298n"), {1, 0, 0}), 0.0, 1.0);
  expect_command(bridge_command(chip("l298n"), {0, 1, 1}), 0.0, 0.0);
}

TEST(MotorDriver, L298nWithPwmOnItsInputsBrakesBetweenPulses) {
  expect_command(bridge_command(chip("l298n"), {1, 0.4, 0}), 0.4, 0.6);
  expect_command(bridge_command(chip("l298n"), {1, 0, 0.4}), -0.4, 0.6);
}

TEST(MotorDriver, Tb6612BrakesBetweenPulsesAndCoastsWithBothInputsLow) {
  expect_command(bridge_command(chip("tb6612"), {0.3, 1, 0}), 0.3, 0.7);
  expect_command(bridge_command(chip("tb6612"), {0.3, 0, 0}), 0.0, 0.0);
}

TEST(MotorDriver, Drv8833CoastsWithOneInputPulsedAndTheOtherLow) {
  expect_command(bridge_command(chip("drv8833"), {1, 0.4, 0}), 0.4, 0.0);
  expect_command(bridge_command(chip("drv8833"), {1, 1, 0.6}), 0.4, 0.6);
}

TEST(MotorDriver, PhaseAndEnable) {
  expect_command(bridge_command(chip("drv8835"), {0.25, 1, 0, true}), 0.25, 0.75);
  expect_command(bridge_command(chip("drv8835"), {0.25, 0, 0, true}), -0.25, 0.75);
}

TEST(MotorDriver, LockedAntiphaseAtHalfDutyHoldsTheMotor) {
  expect_command(bridge_command(chip("l298n"), {1, 0.5, 0, true}), 0.0, 1.0);
  expect_command(bridge_command(chip("l298n"), {1, 0.75, 0, true}), 0.5, 0.5);
}

TEST(Motor, ForwardOnBothDrivesForward) {
  BenchRobot bench(kMotors);
  for (const Pin pin : {5, 7, 6, 9}) bench.board.output(pin, true, 0);
  bench.ticks(200);
  EXPECT_GT(bench.body().speed(), 0.5);
  EXPECT_NEAR(bench.body().turn_rate(), 0.0, 1e-9);
  EXPECT_TRUE(bench.robot.driven());
}

TEST(Motor, TheCommandIsTheTimeAverageOverTheTick) {
  BenchRobot bench(kMotors);
  bench.board.output(7, true, 0);
  bench.board.pwm(5, 0.5, 250 * kMicrosecond);
  bench.board.pwm(5, 0.1, 750 * kMicrosecond);
  bench.tick();
  EXPECT_NEAR(bench.robot.left_command(), 0.5 * 0.5 + 0.25 * 0.1, 1e-12);
  bench.tick();
  EXPECT_NEAR(bench.robot.left_command(), 0.1, 1e-12);
  EXPECT_EQ(bench.robot.right_command(), 0.0);
}

TEST(Motor, InputsThatNobodyDrivesAreLow) {
  BenchRobot bench(kMotors);
  bench.tick();
  EXPECT_FALSE(bench.robot.driven());
}

TEST(Motor, AnUnpoweredBoardStopsTheMotors) {
  BenchRobot bench(kMotors);
  for (const Pin pin : {5, 7, 6, 9}) bench.board.output(pin, true, 0);
  bench.tick();
  for (const Pin pin : {5, 7, 6, 9}) bench.board.input(pin, false, bench.now);
  bench.tick();
  EXPECT_FALSE(bench.robot.driven());
}

TEST(Motor, StandbyLowOpensBothBridges) {
  Description robot = parse_description(kBareRobot + "standby = 4\n" + kMotors, "bench.toml");
  BenchRobot bench(robot);
  for (const Pin pin : {5, 7}) bench.board.output(pin, true, 0);
  bench.tick();
  EXPECT_FALSE(bench.robot.driven());
  bench.board.output(4, true, bench.now);
  bench.tick();
  EXPECT_EQ(bench.robot.left_command(), 1.0);
}

TEST(Motor, ReversedAndSwappedAreProperties) {
  BenchRobot bench(R"(
[[part]]
name = "a"
type = "motor"
wheel = "right"
reversed = true
pins = { in1 = 5, in2 = 6 }
[[part]]
name = "b"
type = "motor"
wheel = "left"
pins = { en = 9, phase = 10 }
)");
  bench.board.pwm(5, 0.5, 0);
  bench.board.pwm(9, 0.25, 0);
  bench.tick();
  EXPECT_EQ(bench.robot.right_command(), -0.5);
  EXPECT_EQ(bench.robot.left_command(), -0.25);
}

TEST(Motor, Faults) {
  BenchRobot bench(kMotors);
  for (const Pin pin : {5, 7}) bench.board.output(pin, true, 0);
  const auto with = [&](const char* kind, std::vector<std::string> arguments) {
    bench.robot.fault("left", kind, arguments);
    bench.tick();
    return bench.robot.left_command();
  };
  EXPECT_EQ(with("dead", {}), 0.0);
  EXPECT_EQ(with("weak", {"80%"}), 0.8);
  EXPECT_EQ(with("reversed", {}), -1.0);
  EXPECT_EQ(with("ok", {}), 1.0);
}

TEST(Motor, AStuckWheelTurnsNeitherByItsMotorNorByTheFloor) {
  BenchRobot bench(kMotors);
  for (const Pin pin : {5, 7, 6, 9}) bench.board.output(pin, true, 0);
  bench.ticks(200);
  bench.robot.fault("left", "stuck", {});
  bench.ticks(200);
  EXPECT_EQ(bench.body().wheel_rate(world::left), 0.0);
  EXPECT_EQ(bench.robot.left_command(), 1.0);
  bench.robot.fault("left", "ok", {});
  bench.ticks(200);
  EXPECT_GT(bench.body().wheel_rate(world::left), 10.0);
}

TEST(Motor, ABatteryWithLessVoltageDrivesSlower) {
  BenchRobot bench(kMotors);
  for (const Pin pin : {5, 7, 6, 10}) bench.board.output(pin, true, 0);
  bench.ticks(4000);
  const double healthy = bench.body().wheel_rate(world::left);
  EXPECT_EQ(bench.robot.battery(), 6.0);
  bench.robot.set_battery(3.0);
  bench.ticks(4000);
  EXPECT_NEAR(bench.body().wheel_rate(world::left), 0.5 * healthy, 0.15 * healthy);
  bench.robot.set_battery(std::nullopt);
  bench.ticks(4000);
  EXPECT_NEAR(bench.body().wheel_rate(world::left), healthy, 1e-3 * healthy);
}

}  // namespace motor_test
}  // namespace robosim::robot
