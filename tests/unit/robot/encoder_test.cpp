// Tests wheel encoders: levels, edges and faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace encoder_test {

constexpr Pin kA = 2;
constexpr Pin kB = 3;

std::string with_motors(const std::string& encoder) {
  return "[[part]]\nname = \"left\"\ntype = \"motor\"\npins = { in1 = 5, in2 = 6 }\n"
         "[[part]]\nname = \"right\"\ntype = \"motor\"\npins = { in1 = 9, in2 = 10 }\n"
         "[[part]]\nname = \"encoder_left\"\ntype = \"encoder\"\n" +
         encoder;
}

const std::string kQuadrature = with_motors("pins = { a = 2, b = 3 }\nperiods = 154.35\n");

void drive(BenchRobot& bench, bool forward) {
  for (const Pin pin : {5, 9}) bench.board.output(pin, forward, bench.now);
  for (const Pin pin : {6, 10}) bench.board.output(pin, !forward, bench.now);
}

// Counts edges as firmware does with an interrupt for each channel: +1 if A leads B, -1 if B leads A.
long count_quadrature(const std::vector<FakeBoard::Edge>& edges) {
  bool a = true, b = true;
  long count = 0;
  for (const auto& edge : edges) {
    (edge.pin == kA ? a : b) = edge.level;
    count += (edge.pin == kA) == (a != b) ? 1 : -1;
  }
  return count;
}

TEST(Encoder, BothChannelsAreHighBeforeTheFirstTurn) {
  BenchRobot bench(kQuadrature);
  EXPECT_TRUE(bench.level(kA));
  EXPECT_TRUE(bench.level(kB));
}

TEST(Encoder, EdgesCountTheWheelsAngleForwardAndBackward) {
  BenchRobot bench(kQuadrature);
  bench.board.edges_wanted = true;
  bench.tick();
  const auto expected = [&] {
    return bench.body().wheel_angle(world::left) / (2 * std::numbers::pi) * 4 * 154.35;
  };
  drive(bench, true);
  bench.ticks(100);
  EXPECT_GT(expected(), 50.0);
  EXPECT_NEAR(static_cast<double>(count_quadrature(bench.board.edges)), expected(), 8.0);
  drive(bench, false);
  bench.ticks(400);
  EXPECT_LT(expected(), -50.0);
  EXPECT_NEAR(static_cast<double>(count_quadrature(bench.board.edges)), expected(), 8.0);
}

TEST(Encoder, EveryEdgeIsExactlyWhereTheLevelChanges) {
  BenchRobot bench(kQuadrature);
  bench.board.edges_wanted = true;
  bench.tick();
  drive(bench, true);
  std::size_t seen = 0;
  for (int i = 0; i < 300; ++i) {
    if (i == 200) drive(bench, false);
    bench.tick();
    for (; seen < bench.board.edges.size(); ++seen) {
      const auto& edge = bench.board.edges[seen];
      ASSERT_GE(edge.at, bench.now);
      ASSERT_LT(edge.at, bench.now + kTick);
      EXPECT_EQ(bench.board.read_level(edge.pin, edge.at), edge.level);
      if (edge.at > bench.now) {
        EXPECT_EQ(bench.board.read_level(edge.pin, edge.at - 1), !edge.level);
      }
    }
  }
  EXPECT_GT(seen, 100u);
}

TEST(Encoder, LevelsAlternateOnEachChannel) {
  BenchRobot bench(kQuadrature);
  bench.board.edges_wanted = true;
  bench.tick();
  drive(bench, true);
  bench.ticks(200);
  drive(bench, false);
  bench.ticks(200);
  bool level[2] = {true, true};
  for (const auto& edge : bench.board.edges) {
    bool& now = level[edge.pin == kB];
    EXPECT_NE(edge.level, now);
    now = edge.level;
  }
}

TEST(Encoder, NobodyListeningCostsNothingAndReadsStillHold) {
  BenchRobot quiet(kQuadrature), followed(kQuadrature);
  followed.board.edges_wanted = true;
  for (BenchRobot* bench : {&quiet, &followed}) {
    bench->tick();
    drive(*bench, true);
    bench->ticks(150);
  }
  EXPECT_TRUE(quiet.board.edges.empty());
  EXPECT_EQ(quiet.level(kA), followed.level(kA));
  EXPECT_EQ(quiet.level(kB), followed.level(kB));
}

TEST(Encoder, WhoListensLateHearsNothingOfThePast) {
  BenchRobot bench(kQuadrature);
  drive(bench, true);
  bench.ticks(150);
  bench.board.edges_wanted = true;
  bench.tick();
  EXPECT_THAT(bench.board.edges.size(), ::testing::Lt(10u));
  for (const auto& edge : bench.board.edges) EXPECT_GT(edge.at, bench.now);
}

TEST(Encoder, WhoListensAgainHearsNothingOfThePause) {
  BenchRobot bench(kQuadrature);
  bench.board.edges_wanted = true;
  drive(bench, true);
  bench.ticks(50);
  bench.board.edges_wanted = false;
  bench.ticks(100);
  bench.board.edges.clear();
  bench.board.edges_wanted = true;
  bench.tick();
  EXPECT_THAT(bench.board.edges.size(), ::testing::Lt(10u));
}

TEST(Encoder, ASingleChannelServesOnePin) {
  BenchRobot bench(with_motors("wheel = \"right\"\npins = { a = 2 }\nperiods = 20\n"));
  bench.board.edges_wanted = true;
  bench.tick();
  drive(bench, true);
  bench.ticks(1000);
  const double turns = bench.body().wheel_angle(world::right) / (2 * std::numbers::pi);
  EXPECT_NEAR(static_cast<double>(bench.board.edges.size()), 40 * turns, 2.0);
}

TEST(Encoder, ADeadOneNeverChanges) {
  BenchRobot bench(kQuadrature);
  bench.board.edges_wanted = true;
  bench.robot.fault("encoder_left", "dead", {});
  drive(bench, true);
  bench.ticks(100);
  EXPECT_TRUE(bench.board.edges.empty());
  EXPECT_TRUE(bench.level(kA));
  bench.robot.fault("encoder_left", "ok", {});
  bench.ticks(10);
  EXPECT_FALSE(bench.board.edges.empty());
}

}  // namespace encoder_test
}  // namespace robosim::robot
