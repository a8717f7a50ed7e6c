// Tests radio receivers with pins for clock, data and enable.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace radio_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Pin kClock = 2, kEnable = 3, kData = 5;

constexpr const char* kRadio = R"(
[[part]]
name = "remote"
type = "radio"
bit = "1 ms"
pins = { clock = 2, enable = 3, data = 5 }
)";

// Runs for `ticks`. Returns the bits of each message that a sketch receives by interrupts in this time.
std::vector<std::vector<bool>> received(BenchRobot& bench, int ticks) {
  bench.board.edges.clear();
  bench.board.edges_wanted = true;
  bench.ticks(ticks);
  std::vector<std::vector<bool>> messages;
  for (const auto& edge : bench.board.edges) {
    EXPECT_EQ(bench.board.read_level(edge.pin, edge.at), edge.level) << "source and edge must agree";
    if (edge.pin == kEnable && edge.level) messages.emplace_back();
    if (edge.pin == kClock && edge.level) messages.back().push_back(bench.board.read_level(kData, edge.at));
  }
  return messages;
}

TEST(Radio, HandsOnTheBitsInTheirOrder) {
  BenchRobot bench(kRadio);
  bench.robot.send("remote", {"0b101"}, 0);
  EXPECT_THAT(received(bench, 10), ElementsAre(ElementsAre(true, false, true)));
}

TEST(Radio, ClocksInTheMiddleOfEachBitWhileEnableIsHigh) {
  BenchRobot bench(kRadio);
  bench.board.edges_wanted = true;
  bench.tick();
  bench.robot.send("remote", {"0b1"}, bench.now);
  const SimTime t = bench.now;
  const auto level = [&](Pin pin, SimTime us) { return bench.board.read_level(pin, t + us * kMicrosecond); };
  EXPECT_TRUE(level(kEnable, 0));
  EXPECT_FALSE(level(kData, 499));
  EXPECT_TRUE(level(kData, 500));
  EXPECT_FALSE(level(kClock, 999));
  EXPECT_TRUE(level(kClock, 1000));
  EXPECT_FALSE(level(kClock, 1500));
  EXPECT_FALSE(level(kData, 1500));
  EXPECT_TRUE(level(kEnable, 1999));
  EXPECT_FALSE(level(kEnable, 2000));
}

TEST(Radio, MessagesThatOverlapFollowEachOther) {
  BenchRobot bench(kRadio);
  bench.robot.send("remote", {"0b11"}, 0);
  bench.robot.send("remote", {"0b0"}, 0);
  EXPECT_THAT(received(bench, 12), ElementsAre(ElementsAre(true, true), ElementsAre(false)));
  bench.robot.send("remote", {"0b1"}, bench.now);
  EXPECT_THAT(received(bench, 12), ElementsAre(ElementsAre(true)));
}

TEST(Radio, Faults) {
  BenchRobot bench(kRadio);
  bench.robot.fault("remote", "dead", {});
  bench.robot.send("remote", {"0b1"}, 0);
  EXPECT_THAT(received(bench, 5), IsEmpty());
  bench.robot.fault("remote", "noisy", {"100%"});
  bench.robot.send("remote", {"0b10"}, bench.now);
  EXPECT_THAT(received(bench, 5), ElementsAre(ElementsAre(false, true)));
  bench.robot.fault("remote", "ok", {});
  bench.robot.send("remote", {"0b10"}, bench.now);
  EXPECT_THAT(received(bench, 5), ElementsAre(ElementsAre(true, false)));
}

TEST(Radio, AnUnknownOneIsRefusedByName) {
  BenchRobot bench(kRadio);
  EXPECT_NO_THROW(bench.robot.check_send("remote", {"3"}));
  try {
    bench.robot.check_send("rodeo", {"3"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown receiver of robot “"));
  }
}

TEST(Radio, SendsBytesAndBitsAndRefusesAllElse) {
  BenchRobot bench(kRadio);
  EXPECT_NO_THROW(bench.robot.check_send("remote", {"255"}));
  EXPECT_NO_THROW(bench.robot.check_send("remote", {"0b101"}));
  for (const char* text : {"256", "-1", "3.5", "0b", "0b102", ""}) {
    try {
      bench.robot.check_send("remote", {text});
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("expected a byte, 0 to 255, or at most 64 bits such as 0b101"));
    }
  }
}

}  // namespace radio_test
}  // namespace robosim::robot
