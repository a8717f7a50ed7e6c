// Tests infra-red receivers of remote controls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace infrared_test {

using testing::HasSubstr;

constexpr const char* kRemote = "[[part]]\nname = \"ir\"\ntype = \"ir-receiver\"\npin = 2\naddress = 0x04\n";

// Returns the durations in us of alternating low and high levels, until a level lasts 60 ms.
std::vector<SimTime> heard(BenchRobot& bench) {
  std::vector<SimTime> lengths;
  bool level = true;
  SimTime since = -1;
  for (SimTime quiet = 0; quiet < 60000; bench.tick()) {
    for (SimTime us = 0; us < 1000; us += 1, ++quiet) {
      const SimTime t = bench.now + us * kMicrosecond;
      if (bench.board.read_level(2, t) == level) continue;
      if (since >= 0) lengths.push_back((t - since) / kMicrosecond);
      level = !level;
      since = t;
      quiet = 0;
    }
  }
  return lengths;
}

// Decodes the durations of levels to the 32 bits of a message.
std::uint32_t decoded(const std::vector<SimTime>& lengths) {
  std::uint32_t bits = 0;
  for (std::size_t bit = 0; bit < 32; ++bit)
    if (lengths.at(3 + 2 * bit) > 1125) bits |= 1u << bit;
  return bits;
}

TEST(IrReceiver, GivesAKeysMessageByTheNecProtocol) {
  BenchRobot bench(kRemote);
  EXPECT_TRUE(bench.level(2)) << "high at rest";
  bench.robot.send("ir", {"0x45"}, bench.now);
  const auto lengths = heard(bench);
  ASSERT_EQ(lengths.size(), 2u + 64u + 1u);
  EXPECT_NEAR(static_cast<double>(lengths[0]), 9000, 1);
  EXPECT_NEAR(static_cast<double>(lengths[1]), 4500, 1);
  for (std::size_t i = 2; i < lengths.size(); i += 2) EXPECT_NEAR(static_cast<double>(lengths[i]), 562.5, 1);
  EXPECT_EQ(decoded(lengths), 0xBA45FB04u)
      << "from the lowest bit: the address, its inverse, the command, its inverse";
}

TEST(IrReceiver, RepeatsWhileAKeyIsHeld) {
  BenchRobot bench(kRemote);
  bench.board.want_edges(2, bench.now);
  bench.robot.send("ir", {"7", 250 * kMillisecond}, bench.now);
  bench.robot.begin_tick(bench.now);
  bench.ticks(400);
  std::vector<SimTime> falls;
  for (const auto& edge : bench.board.edges)
    if (!edge.level && (falls.empty() || edge.at - falls.back() > 20 * kMillisecond))
      falls.push_back(edge.at);
  std::vector<SimTime> beginnings;
  for (const SimTime at : falls)
    if (at % (108 * kMillisecond) < kMillisecond) beginnings.push_back(at);
  EXPECT_EQ(beginnings.size(), 3u) << "a message and two repeats";
}

TEST(IrReceiver, RefusesWhatIsNoCommand) {
  BenchRobot bench(kRemote);
  EXPECT_NO_THROW(bench.robot.check_send("ir", {"255"}));
  try {
    bench.robot.check_send("ir", {"0x145"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("send ir: expected a command from 0 to 255, such as 0x45, got “0x145”"));
  }
}

TEST(IrReceiver, HearsNothingWhenItIsDead) {
  BenchRobot bench(kRemote);
  bench.robot.fault("ir", "dead", {});
  bench.robot.send("ir", {"0x45"}, bench.now);
  EXPECT_TRUE(heard(bench).empty());
}

}  // namespace infrared_test
}  // namespace robosim::robot
