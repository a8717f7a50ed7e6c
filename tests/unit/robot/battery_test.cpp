// Compares the model of the table [battery] with closed-form solutions.
#include "sim/robot/battery.h"

#include <gmock/gmock.h>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace battery_test {

using ::testing::HasSubstr;

constexpr double kBoard = 0.05;  // the board's current in A

void stall(BenchRobot& bench, double drive) {
  for (const Side side : {world::left, world::right}) {
    bench.body().block(side, true);
    bench.body().command(side, {drive, 0.0});
  }
}

// Returns the battery's voltage with two stalled motors. A motor has 3.75 ohm (6 V, 1.6 A), and its driver
// has 0.5 ohm. `rest` is the open-circuit voltage, and `ohms` the battery's resistance.
double loaded(double rest, double ohms, double drive) {
  const double motor = 6.0 / 1.6 + 0.5;
  return (rest - ohms * kBoard) / (1.0 + 2.0 * drive * ohms / motor);
}

TEST(Battery, OfTwoLithiumCellsSagsByTwoPerCentUnderTwoStalledMotors) {
  BenchRobot bench("[battery]\nkind = \"li-ion\"\ncells = 2\ncapacity_mAh = 450\n");
  bench.ticks(1);
  EXPECT_NEAR(*bench.robot.fed_volts(), 2 * 4.172 - 0.06 * kBoard, 1e-5);
  stall(bench, 1.0);
  bench.ticks(2);
  EXPECT_NEAR(*bench.robot.fed_volts(), loaded(2 * 4.172, 0.06, 1.0), 0.001);
  stall(bench, 0.5);
  bench.ticks(2);
  EXPECT_NEAR(*bench.robot.fed_volts(), loaded(2 * 4.172, 0.06, 0.5), 0.001);
}

TEST(Battery, OfFourAlkalineCellsSagsByAThird) {
  BenchRobot bench("[battery]\nkind = \"alkaline\"\ncells = 4\ncapacity_mAh = 2000\n");
  stall(bench, 1.0);
  bench.ticks(2);
  EXPECT_NEAR(*bench.robot.fed_volts(), loaded(6.4, 0.8, 1.0), 0.001);
  EXPECT_LT(*bench.robot.fed_volts(), 0.75 * 6.4);
}

TEST(Battery, RunsEmptyAsItsCurrentSays) {
  BenchRobot bench(
      "[battery]\nkind = \"nimh\"\ncells = 5\ncapacity_mAh = 1\nboard = \"100 mA\"\nresistance = \"0 "
      "ohm\"\n");
  bench.ticks(18000);  // 18 s at 0.1 A use half of 1 mAh
  EXPECT_NEAR(*bench.robot.fed_volts(), 5 * 1.25, 1e-3);
  bench.ticks(18000);
  EXPECT_NEAR(*bench.robot.fed_volts(), 5 * 1.00, 1e-2);
  bench.ticks(1000);
  EXPECT_EQ(*bench.robot.fed_volts(), 0.0);
}

TEST(Battery, WhoseVoltsAScriptSaysDoesNotSagUntilThatIsOver) {
  BenchRobot bench("[battery]\nkind = \"li-ion\"\ncells = 2\ncapacity_mAh = 450\n");
  bench.robot.set_battery(5.0);
  EXPECT_FALSE(bench.robot.fed_volts());
  bench.robot.set_battery(bench.robot.battery());
  EXPECT_FALSE(bench.robot.fed_volts()) << "a script may also set a healthy battery's voltage";
  bench.robot.set_battery(std::nullopt);
  bench.ticks(1);
  EXPECT_NEAR(*bench.robot.fed_volts(), 8.34, 0.01);
}

TEST(Battery, ThatMakesNoSenseIsRefusedWithPlaceAndReason) {
  const struct {
    const char* table;
    const char* message;
  } refused[] = {
      {"cells = 2\ncapacity_mAh = 450", "[battery] lacks the key kind"},
      {"kind = \"li-ion\"\ncapacity_mAh = 450", "[battery] lacks the key cells"},
      {"kind = \"li-ion\"\ncells = 2", "[battery] lacks the key capacity_mAh"},
      {"kind = \"lead\"\ncells = 2\ncapacity_mAh = 450", "kind: expected li-ion, nimh or alkaline"},
      {"kind = \"nimh\"\ncells = 0\ncapacity_mAh = 450",
       "cells: expected a whole number from 1 to 12, got 0"},
      {"kind = \"nimh\"\ncells = 2.5\ncapacity_mAh = 450", "cells: expected a whole number, got 2.5"},
      {"kind = \"nimh\"\ncells = 4\ncapacity_mAh = 0", "capacity_mAh: expected 1 to 100000, got 0"},
      {"kind = \"nimh\"\ncells = 4\ncapacity_mAh = \"2 Ah\"",
       "capacity_mAh: expected a bare number or %, got \"2 Ah\""},
      {"kind = \"nimh\"\ncells = 4\ncapacity_mAh = 9\nresistance = \"3 V\"",
       "resistance: expected a number with a unit (ohm or kohm), got \"3 V\""},
      {"kind = \"nimh\"\ncells = 4\ncapacity_mAh = 9\ncharge = 1.5", "charge: expected 0 to 1, got 1.5"},
      {"kind = \"nimh\"\ncells = 4\ncapacity_mAh = 9\nboard = \"-1 mA\"", "board: expected 0 to 2000 mA"},
      {"kind = \"nimh\"\ncells = 4\ncapacity_mAh = 9\nvolts = 3", "volts"},
  };
  for (const auto& one : refused) {
    try {
      parse_description(kBareRobot + "[battery]\n" + one.table + "\n", "bench.toml");
      ADD_FAILURE() << one.table;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(one.message)) << one.table;
    }
  }
}

}  // namespace battery_test
}  // namespace robosim::robot
