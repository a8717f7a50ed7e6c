// Tests the table [electronics] of a robot file: supply voltage, emitters and noise of the ADC.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/error.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace electronics_test {

const std::string kParts =
    "[[part]]\nname = \"battery\"\ntype = \"voltage\"\npin = \"A0\"\nshare = 0.5\n"
    "[[part]]\nname = \"eye\"\ntype = \"reflectance\"\npin = \"A1\"\nat = [\"0 mm\", \"0 mm\"]\n"
    "white_volts = \"0 V\"\nblack_volts = \"4 V\"\nnoise = 0\n";

std::string electronics(const std::string& keys) { return "[electronics]\n" + keys + kParts; }

TEST(Electronics, WithoutThemTheSupplyNeverSinks) {
  BenchRobot bench(kParts);
  bench.robot.set_battery(4.0);
  EXPECT_DOUBLE_EQ(bench.volts(kA0), 2.0);
}

// A Nano's regulator and diode drop 1.8 V. With a battery of 5.8 V, the supply is therefore 4 V instead of
// 5 V. The divider's 2.9 V are then 2.9 / 4 of the ADC's range.
TEST(Electronics, ABatteryReadsHigherWhereTheReferenceSinksWithIt) {
  BenchRobot bench(electronics("fed_by_battery = true\n"));
  bench.robot.set_battery(7.0);
  EXPECT_DOUBLE_EQ(bench.volts(kA0), 3.5);
  EXPECT_EQ(bench.board.supply_volts(), 5.0);
  bench.robot.set_battery(5.8);
  EXPECT_NEAR(bench.volts(kA0), 2.9, 1e-12);
  EXPECT_DOUBLE_EQ(bench.board.supply_volts(), 4.0);
}

TEST(Electronics, EmittersGetDarkerAndBlackStaysBlack) {
  BenchRobot bench(electronics("fed_by_battery = true\n"));
  bench.robot.set_battery(5.8);
  EXPECT_DOUBLE_EQ(bench.volts(kA1), 4.0 * 0.8);
  bench.body().place({bench.line() + Vec2{0.0, 0.03}, {1.0, 0.0}});
  EXPECT_NEAR(bench.volts(kA1), 0.8 * 4.0 * (1.0 - (4.0 - 1.2) / (5.0 - 1.2)), 1e-12);
}

TEST(Electronics, TheAdcIsNoisyInSteps) {
  BenchRobot bench(electronics("adc_noise = 2\n"), Profile::typical);
  double sum = 0.0, squares = 0.0;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const double steps = bench.volts(kA0) / 5.0 * 1024.0;
    sum += steps;
    squares += steps * steps;
  }
  const double mean = sum / kCount;
  EXPECT_NEAR(mean, 3.0 / 5.0 * 1024.0, 0.15);
  EXPECT_NEAR(std::sqrt(squares / kCount - mean * mean), 2.0, 0.1);
  EXPECT_NE(bench.volts(kA1), bench.volts(kA1));
  BenchRobot ideal(electronics("adc_noise = 2\n"));
  EXPECT_EQ(ideal.volts(kA1), ideal.volts(kA1)) << "`ideal` has no noise";
}

TEST(Electronics, ThatAreWrongAreRefused) {
  const auto message = [](const std::string& keys) -> std::string {
    try {
      BenchRobot bench(electronics(keys));
      return "accepted";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_NE(message("adc_noise = \"2 V\"\n").find("bench.toml:"), std::string::npos);
  EXPECT_NE(message("fed_by_battery = 3\n").find("fed_by_battery"), std::string::npos);
  EXPECT_NE(message("regulator = \"5 V\"\n").find("adc_noise"), std::string::npos);
}

}  // namespace electronics_test
}  // namespace robosim::robot
