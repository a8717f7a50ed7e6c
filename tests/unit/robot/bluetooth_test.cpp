// Tests the Bluetooth module, which a serial line connects to the board.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace bluetooth_test {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Pin kTxd = 2, kRxd = 3;
constexpr SimTime kBit = kSecond / 9600;

constexpr const char* kModule =
    "[[part]]\nname = \"bt\"\ntype = \"bluetooth\"\npins = { txd = 2, rxd = 3 }\n";

// Returns the text that a receiver at pin kTxd decodes in `ticks`. The receiver samples each bit in its
// middle.
std::string received(BenchRobot& bench, int ticks) {
  std::string text;
  SimTime next = bench.now;
  const SimTime end = bench.now + ticks * kTick;
  const auto level = [&](SimTime t) {
    while (bench.now + kTick <= t) bench.tick();
    return bench.board.read_level(kTxd, t);
  };
  while (next < end) {
    if (level(next)) {
      next += kMicrosecond;
      continue;
    }
    unsigned byte = 0;
    for (int bit = 0; bit < 8; ++bit)
      if (level(next + (3 + 2 * bit) * kBit / 2)) byte |= 1u << bit;
    EXPECT_TRUE(level(next + 19 * kBit / 2)) << "the stop bit";
    text += static_cast<char>(byte);
    next += 19 * kBit / 2;
  }
  return text;
}

// Sends text to the module bit by bit, as a sketch does. Each bit lasts `bit`.
void send(BenchRobot& bench, const std::string& text, SimTime bit = kBit) {
  SimTime at = bench.now;
  for (const char c : text) {
    const unsigned frame = static_cast<unsigned char>(c) << 1 | 1u << 9;
    for (int i = 0; i < 10; ++i, at += bit) {
      while (bench.now + kTick <= at) bench.tick();
      bench.board.output(kRxd, frame >> i & 1, at);
    }
  }
  bench.ticks(2);
}

std::vector<std::string> told(BenchRobot& bench) {
  std::vector<PartText> all;
  for (int i = 0; i < 10; ++i) bench.robot.poll_text(bench.now, all);
  std::vector<std::string> texts;
  for (const PartText& one : all) texts.push_back(one.part + ": " + one.text);
  return texts;
}

TEST(Bluetooth, SendsBytesToTheSketchOneAfterTheOther) {
  BenchRobot bench(kModule);
  EXPECT_TRUE(bench.level(kTxd)) << "high at rest";
  bench.robot.send("bt", {"go\n"}, bench.now);
  EXPECT_EQ(received(bench, 10), "go\n");
  bench.robot.send("bt", {"U"}, bench.now);
  bench.robot.send("bt", {std::string("\0\xFF", 2)}, bench.now);
  EXPECT_EQ(received(bench, 10), std::string("U\0\xFF", 3));
}

TEST(Bluetooth, ItsEdgesReachInterrupts) {
  BenchRobot bench(kModule);
  bench.board.want_edges(kTxd, bench.now);
  bench.tick();
  bench.robot.send("bt", {"U"}, bench.now);
  const SimTime began = bench.now;
  bench.robot.begin_tick(bench.now);
  bench.ticks(3);
  ASSERT_EQ(bench.board.edges.size(), 10u) << "the level changes at every bit of a U";
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_EQ(bench.board.edges[i].at, began + static_cast<SimTime>(i) * kBit);
}

TEST(Bluetooth, TellsLineByLineWhatTheSketchSends) {
  BenchRobot bench(kModule);
  bench.board.output(kRxd, true, bench.now);
  send(bench, "ready\r\n12");
  EXPECT_THAT(told(bench), ElementsAre("bt: ready"));
  send(bench, "3");
  bench.ticks(150);
  EXPECT_THAT(told(bench), IsEmpty());
  bench.ticks(100);
  EXPECT_THAT(told(bench), ElementsAre("bt: 123")) << "the line ends after 200 ms without a byte";
}

TEST(Bluetooth, HearsGarbageAtAnotherBaudRate) {
  BenchRobot bench(kModule);
  bench.board.output(kRxd, true, bench.now);
  send(bench, "ready\n", kBit * 4);
  bench.ticks(300);
  const auto texts = told(bench);
  ASSERT_FALSE(texts.empty());
  EXPECT_NE(texts[0], "bt: ready");
}

TEST(Bluetooth, IsSilentWhenItIsDead) {
  BenchRobot bench(kModule);
  bench.robot.fault("bt", "dead", {});
  bench.robot.send("bt", {"go"}, bench.now);
  EXPECT_EQ(received(bench, 10), "");
}

}  // namespace bluetooth_test
}  // namespace robosim::robot
