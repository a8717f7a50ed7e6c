// Tests reflectance sensors with a digital output. The level depends on a threshold, or it is high while
// a capacitor discharges.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace digital_reflectance_test {

TEST(DigitalReflectance, HasTheConfiguredPolarity) {
  BenchRobot high(reflectance_sensor("read = \"digital\"\n"));
  BenchRobot low(reflectance_sensor("read = \"digital\"\nblack = \"low\"\n"));
  EXPECT_TRUE(high.level(kA0));
  EXPECT_FALSE(low.level(kA0));
  EXPECT_EQ(high.volts(kA0), 5.0);
  place_beside_line(high, 0.03);
  place_beside_line(low, 0.03);
  EXPECT_FALSE(high.level(kA0));
  EXPECT_TRUE(low.level(kA0));
}

TEST(DigitalReflectance, HysteresisKeepsTheStateNearTheThreshold) {
  BenchRobot bench(reflectance_sensor("read = \"digital\"\nthreshold = 0.5\nhysteresis = 0.4\n"));
  place_beside_line(bench, 0.03);
  EXPECT_FALSE(bench.level(kA0));
  place_beside_line(bench, 0.0094);  // blackness 0.6
  EXPECT_FALSE(bench.level(kA0));
  place_beside_line(bench, 0.0);
  EXPECT_TRUE(bench.level(kA0));
  place_beside_line(bench, 0.0106);  // blackness 0.4
  EXPECT_TRUE(bench.level(kA0));
  place_beside_line(bench, 0.03);
  EXPECT_FALSE(bench.level(kA0));
}

TEST(DigitalReflectance, InterruptsSeeItsEdges) {
  BenchRobot bench(reflectance_sensor("read = \"digital\"\n"));
  bench.board.edges_wanted = true;
  bench.tick();
  place_beside_line(bench, 0.03);
  bench.ticks(2);
  using Edge = FakeBoard::Edge;
  EXPECT_THAT(bench.board.edges, ::testing::ElementsAre(Edge{kA0, true, kTick}, Edge{kA0, false, 2 * kTick}));
}

TEST(DigitalReflectance, AnInterruptAttachedOverBlackMeetsNoEdgeUntilTheLineEnds) {
  BenchRobot bench(reflectance_sensor("read = \"digital\"\n"));
  bench.ticks(3);
  bench.board.want_edges(kA0, bench.now);
  bench.ticks(3);
  EXPECT_THAT(bench.board.edges, ::testing::IsEmpty());
  place_beside_line(bench, 0.03);
  bench.tick();
  EXPECT_THAT(bench.board.edges, ::testing::ElementsAre(FakeBoard::Edge{kA0, false, bench.now}));
}

TEST(DigitalReflectance, AnInterruptAttachedAgainMeetsNoEdgeOfTheTimeBetween) {
  BenchRobot bench(reflectance_sensor("read = \"digital\"\n"));
  bench.board.want_edges(kA0, bench.now);
  bench.tick();
  bench.board.edges_wanted = false;
  place_beside_line(bench, 0.03);
  bench.ticks(3);
  bench.board.want_edges(kA0, bench.now);
  bench.ticks(3);
  EXPECT_THAT(bench.board.edges, ::testing::IsEmpty());
}

class RcReflectance : public ::testing::Test {
 protected:
  static std::string keys() {
    return reflectance_sensor("read = \"rc\"\nwhite_time = \"200 us\"\nblack_time = \"2500 us\"\n");
  }
  // Charges the capacitor for `charge` and releases the pin. Returns the exact time until the pin reads low.
  static SimTime time_discharge(BenchRobot& bench, SimTime charge = 10 * kMicrosecond) {
    const SimTime begin = bench.now;
    bench.board.output(kA0, true, begin);
    bench.board.input(kA0, false, begin + charge);
    SimTime low = 0, high = 4 * kMillisecond;
    while (high - low > 1) {
      const SimTime middle = (low + high) / 2;
      (bench.board.read_level(kA0, begin + charge + middle) ? low : high) = middle;
    }
    return high;
  }
};

TEST_F(RcReflectance, TakesBlackTimeOverBlackAndWhiteTimeOverWhite) {
  BenchRobot bench(keys());
  EXPECT_EQ(time_discharge(bench), 2500 * kMicrosecond);
  place_beside_line(bench, 0.03);
  bench.ticks(5);
  EXPECT_EQ(time_discharge(bench), 200 * kMicrosecond);
}

TEST_F(RcReflectance, HalfwayTheDischargeRatesAverage) {
  BenchRobot bench(keys());
  place_beside_line(bench, 0.010);
  const double expected = 1.0 / (0.5 / 2500e3 + 0.5 / 200e3);
  EXPECT_NEAR(static_cast<double>(time_discharge(bench)), expected, 2.0);
}

TEST_F(RcReflectance, AHalfChargedCapacitorIsLowAtOnce) {
  BenchRobot bench(keys());
  EXPECT_EQ(time_discharge(bench, 5 * kMicrosecond), 1);
}

TEST_F(RcReflectance, ThreeQuartersOfTheChargeLastHalfTheTime) {
  BenchRobot bench(keys());
  EXPECT_NEAR(static_cast<double>(time_discharge(bench, 7500)), 1250e3, 2.0);
}

TEST_F(RcReflectance, ReadsHighWhileItIsChargedAndLowBefore) {
  BenchRobot bench(keys());
  EXPECT_FALSE(bench.level(kA0));
  bench.board.output(kA0, true, 0);
  EXPECT_TRUE(bench.board.read_level(kA0, 5 * kMicrosecond));
}

TEST_F(RcReflectance, ItsFallIsAnEdgeInTheTickInWhichItHappens) {
  BenchRobot bench(keys());
  bench.board.edges_wanted = true;
  bench.board.output(kA0, true, 0);
  bench.board.input(kA0, false, 10 * kMicrosecond);
  EXPECT_TRUE(bench.board.edges.empty()) << "the pin falls two ticks later";
  bench.ticks(3);
  EXPECT_THAT(bench.board.edges, ::testing::ElementsAre(FakeBoard::Edge{kA0, false, 2510 * kMicrosecond}));
}

}  // namespace digital_reflectance_test
}  // namespace robosim::robot
