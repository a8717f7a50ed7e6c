// Tests sensors that measure distances along the floor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/robot/parts/ir_distance.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace distance_test {

constexpr Pin kTrig = 2, kEcho = 3;

constexpr const char* kSonar = R"(
[[part]]
name = "sonar"
type = "hc-sr04"
pins = { trig = 2, echo = 3 }
at = ["60 mm", "0 mm"]
)";

/// Returns the distance from the bench robot's axle to the map's edge ahead.
double to_edge(BenchRobot& bench) {
  return bench.map.width * bench.map.cell_m - bench.body().pose().position.x;
}

void trigger(BenchRobot& bench, SimTime at, SimTime width = 10 * kMicrosecond, Pin pin = kTrig) {
  bench.board.output(pin, true, at);
  bench.board.output(pin, false, at + width);
}

// Returns the duration of the echo pulse in s, or 0 if no pulse ends within 50 ms.
double echo(BenchRobot& bench, Pin pin = kEcho) {
  SimTime rise = -1;
  for (int ms = 0; ms < 50; ++ms) {
    for (SimTime us = 0; us < 1000; ++us) {
      const SimTime t = bench.now + us * kMicrosecond;
      const bool level = bench.board.read_level(pin, t);
      if (level && rise < 0) rise = t;
      if (!level && rise >= 0) return static_cast<double>(t - rise) * 1e-9;
    }
    bench.tick();
  }
  return 0.0;
}

TEST(HcSr04, TellsTheWayToTheWallByItsEcho) {
  BenchRobot bench(kSonar);
  trigger(bench, bench.now);
  EXPECT_NEAR(echo(bench) * 343.0 / 2.0, to_edge(bench) - 0.06, 0.0005);
  bench.world.add_obstacle(bench.line() + Vec2{0.3, 0.0}, 0.033);
  bench.ticks(60);
  trigger(bench, bench.now);
  EXPECT_NEAR(echo(bench) * 343.0 / 2.0, 0.3 - 0.033 - 0.06, 0.0005);
  EXPECT_NEAR(bench.robot.readings().back().value, 20.7, 1e-9) << "readings are in cm";
}

TEST(HcSr04, RisesAndFallsWhenInterruptsSeeIt) {
  BenchRobot bench(kSonar);
  bench.board.want_edges(kEcho, bench.now);
  const SimTime at = bench.now + 100 * kMicrosecond;
  trigger(bench, at);
  bench.ticks(50);
  ASSERT_EQ(bench.board.edges.size(), 2u);
  const auto& [rise, fall] = std::tie(bench.board.edges[0], bench.board.edges[1]);
  EXPECT_TRUE(rise.level);
  EXPECT_EQ(rise.at, at + 460 * kMicrosecond) << "450 us after the end of the trigger";
  EXPECT_FALSE(fall.level);
  EXPECT_NEAR(static_cast<double>(fall.at - rise.at) * 1e-9, 2.0 * (to_edge(bench) - 0.06) / 343.0, 1e-8);
  EXPECT_TRUE(bench.board.read_level(kEcho, fall.at - 1));
  EXPECT_FALSE(bench.board.read_level(kEcho, fall.at));
}

TEST(HcSr04, WaitsInVainFor38MillisecondsWhereNothingIsNear) {
  BenchRobot bench(std::string(kSonar) + "reach = \"100 mm\"\n");
  trigger(bench, bench.now);
  EXPECT_NEAR(echo(bench), 0.038, 2e-6);
}

TEST(HcSr04, NeedsTenMicrosecondsToBeTriggered) {
  BenchRobot bench(kSonar);
  trigger(bench, bench.now, 5 * kMicrosecond);
  EXPECT_EQ(echo(bench), 0.0);
}

TEST(HcSr04, DoesNotHearATriggerBeforeItsEchoIsOver) {
  BenchRobot bench(kSonar);
  trigger(bench, bench.now);
  bench.tick();
  ASSERT_TRUE(bench.board.read_level(kEcho, bench.now));
  const double way = to_edge(bench) - 0.06;
  bench.world.add_obstacle(bench.line() + Vec2{0.2, 0.0}, 0.033);
  trigger(bench, bench.now);
  EXPECT_NEAR(echo(bench) * 343.0 / 2.0, way, 0.1) << "the first measurement continues";
  bench.tick();
  EXPECT_EQ(echo(bench), 0.0);
}

TEST(HcSr04, SeesWhatIsInItsBeamAndNothingBeside) {
  for (const auto& [aside, seen] :
       std::vector<std::pair<double, bool>>{{0.0, true}, {0.05, true}, {0.065, true}, {0.12, false}}) {
    BenchRobot bench(kSonar);
    bench.world.add_obstacle(bench.line() + Vec2{0.06 + 0.25, aside}, 0.033);
    trigger(bench, bench.now);
    const double way = echo(bench) * 343.0 / 2.0;
    EXPECT_EQ(way < 0.26, seen) << aside << " " << way;
  }
}

TEST(HcSr04, LooksWhereItIsMounted) {
  BenchRobot bench(std::string(kSonar) + "facing = \"90 deg\"\n");
  const double aside = bench.map.height * bench.map.cell_m - bench.body().pose().position.y;
  trigger(bench, bench.now);
  EXPECT_NEAR(echo(bench) * 343.0 / 2.0, aside, 0.0005);
}

TEST(HcSr04, OnAServoLooksWhereThatPointsTo) {
  BenchRobot bench(R"(
[[part]]
name = "pan"
type = "servo"
pin = 9
at = ["50 mm", "0 mm"]
[[part]]
name = "sonar"
type = "hc-sr04"
pins = { trig = 2, echo = 3 }
at = ["10 mm", "0 mm"]
on = "pan"
)");
  const double height = bench.map.height * bench.map.cell_m, y = bench.body().pose().position.y;
  trigger(bench, bench.now);
  EXPECT_NEAR(echo(bench) * 343.0 / 2.0, to_edge(bench) - 0.06, 0.0005);
  for (const bool left : {true, false}) {
    bench.board.output(9, true, bench.now);
    if (left) bench.ticks(2);
    bench.board.output(9, false, bench.now + (left ? 400 : 544) * kMicrosecond);
    bench.ticks(500);
    trigger(bench, bench.now);
    EXPECT_NEAR(echo(bench) * 343.0 / 2.0, (left ? height - y : y) - 0.01, 0.0005);
    bench.ticks(60);
  }
}

TEST(HcSr04, WithOneWireAnswersOnIt) {
  BenchRobot bench(R"(
[[part]]
name = "sonar"
type = "hc-sr04"
pins = { sig = 7 }
)");
  trigger(bench, bench.now, 12 * kMicrosecond, 7);
  bench.board.input(7, false, bench.now + 20 * kMicrosecond);
  EXPECT_NEAR(echo(bench, 7) * 343.0 / 2.0, to_edge(bench), 0.0005);
}

TEST(HcSr04, IsSilentWhenItIsDead) {
  BenchRobot bench(kSonar);
  bench.robot.fault("sonar", "dead", {});
  trigger(bench, bench.now);
  EXPECT_EQ(echo(bench), 0.0);
}

TEST(HcSr04, ErrsByMillimetresInTheTypicalProfile) {
  BenchRobot bench(kSonar, Profile::typical);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < 100; ++i) {
    trigger(bench, bench.now);
    const double error = echo(bench) * 343.0 / 2.0 - (to_edge(bench) - 0.06);
    sum += error;
    squares += error * error;
    bench.ticks(10);
  }
  EXPECT_NEAR(sum / 100, 0.0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / 100), 0.0015, 0.0005);
}

TEST(IrDistance, FollowsTheDataSheetsCurve) {
  EXPECT_DOUBLE_EQ(ir_volts(0.1), 2.3);
  EXPECT_DOUBLE_EQ(ir_volts(0.8), 0.4);
  EXPECT_NEAR(ir_volts(0.1) - ir_volts(0.8), 1.9, 1e-9) << "the typical value in the data sheet's table";
  EXPECT_NEAR(ir_volts(0.125), 0.5 * (2.3 + 1.65), 1e-9);
  EXPECT_LT(ir_volts(0.03), ir_volts(0.06)) << "at short distances, the voltage falls again";
  EXPECT_NEAR(ir_volts(1.6), 0.2, 1e-9);
  for (double d = 0.06; d < 2.0; d += 0.01) EXPECT_GT(ir_volts(d), ir_volts(d + 0.01)) << d;
}

TEST(IrDistance, GivesTheVoltsOfTheWayAheadAndHoldsThemForAMeasurement) {
  BenchRobot bench(R"(
[[part]]
name = "ir"
type = "ir-distance"
pin = "A0"
at = ["60 mm", "0 mm"]
)");
  EXPECT_EQ(bench.volts(14), 0.0) << "the sensor has not measured yet";
  bench.ticks(38);
  EXPECT_NEAR(bench.volts(14), ir_volts(to_edge(bench) - 0.06), 1e-9);
  bench.world.add_obstacle(bench.line() + Vec2{0.293, 0.0}, 0.033);
  bench.ticks(37);
  EXPECT_NEAR(bench.volts(14), ir_volts(to_edge(bench) - 0.06), 1e-9);
  bench.ticks(2);
  EXPECT_NEAR(bench.volts(14), ir_volts(0.2), 1e-9);
  bench.robot.fault("ir", "dead", {});
  EXPECT_EQ(bench.volts(14), 0.0);
}

TEST(IrSwitch, SaysWhetherSomethingIsNear) {
  BenchRobot bench(R"(
[[part]]
name = "ahead"
type = "ir-switch"
pin = 4
at = ["60 mm", "0 mm"]
range = "10 cm"
)");
  bench.board.want_edges(4, bench.now);
  EXPECT_TRUE(bench.level(4)) << "high: nothing is near";
  const int can = bench.world.add_obstacle(bench.line() + Vec2{0.06 + 0.033 + 0.095, 0.0}, 0.033);
  bench.tick();
  EXPECT_FALSE(bench.level(4));
  bench.world.remove_obstacle(can);
  bench.world.add_obstacle(bench.line() + Vec2{0.06 + 0.033 + 0.105, 0.0}, 0.033);
  bench.tick();
  EXPECT_FALSE(bench.level(4)) << "the switch turns off slightly farther away";
  bench.body().place({bench.line() - Vec2{0.02, 0.0}, {1.0, 0.0}});
  bench.tick();
  EXPECT_TRUE(bench.level(4));
  bench.robot.fault("ahead", "stuck", {});
  bench.tick();
  EXPECT_FALSE(bench.level(4));
  ASSERT_EQ(bench.board.edges.size(), 3u);
  EXPECT_FALSE(bench.board.edges[0].level);
}

}  // namespace distance_test
}  // namespace robosim::robot
