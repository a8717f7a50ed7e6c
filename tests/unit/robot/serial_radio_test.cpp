// Tests serial radios of several robots on one floor.
#include <gtest/gtest.h>

#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace serial_radio_test {

std::string radio(const std::string& keys, const std::string& pins = "txd = 2, rxd = 3") {
  return "[[part]]\nname = \"air\"\ntype = \"serial-radio\"\npins = { " + pins + " }\n" + keys;
}

/// Two robots in one world, each with a radio. The radios may have different keys in their robot files.
class Pair {
 public:
  explicit Pair(const std::string& keys, const std::string& other_keys, std::uint64_t seed = 1)
      : first(parse_description(kBareRobot + radio(keys), "first.toml")),
        second(parse_description(kBareRobot + radio(other_keys), "second.toml")),
        map(map::parse_map("___________\n_111111111_\n___________\n", "pair.map")),
        world(map),
        board_a(*first.board),
        board_b(*second.board),
        a(first, world, add(first, {2, 1}), board_a, seed, Profile::ideal, 0),
        b(second, world, add(second, {8, 1}), board_b, seed, Profile::ideal, 1) {
    a.begin_tick(0);
    b.begin_tick(0);
  }
  std::size_t add(const Description& d, map::CellAt cell) {
    return world.add_body(body_params(d, 1, Profile::ideal), {map.centre({cell.x, cell.y}), {1.0, 0.0}});
  }
  /// Sends the byte 0xFF from the first robot. Only the start bit of its frame is low.
  void send() {
    ticks(1);
    board_a.output(3, false, now);
    board_a.output(3, true, now + kSecond / 9600);
    ticks(2);
  }
  /// Returns the number of bytes that the second board received. Each byte has two edges.
  std::size_t heard() const { return board_b.edges.size() / 2; }
  void ticks(int count) {
    for (; count > 0; --count) {
      now += kTick;
      a.begin_tick(now);
      b.begin_tick(now);
    }
  }
  Description first, second;
  map::Map map;
  world::World world;
  FakeBoard board_a, board_b;
  Robot a, b;
  SimTime now = 0;
};

TEST(SerialRadio, ReachesTheOthersAfterItsDelay) {
  Pair pair("delay = \"30 ms\"\n", "");
  pair.send();
  const SimTime sent = pair.now;
  pair.ticks(27);
  EXPECT_EQ(pair.heard(), 0u);
  pair.ticks(10);
  ASSERT_EQ(pair.heard(), 1u);
  EXPECT_EQ(pair.board_b.edges[0].pin, 2);
  EXPECT_NEAR(static_cast<double>(pair.board_b.edges[0].at - sent), 29e6, 2e6);
  EXPECT_TRUE(pair.board_a.edges.empty()) << "a radio does not receive its own bytes";
}

TEST(SerialRadio, LosesItsShareOfTheBytesTheSameOnesForTheSameSeed) {
  const auto heard = [](std::uint64_t seed) {
    Pair pair("", "loss = 0.25\n", seed);
    std::vector<std::size_t> counts;
    for (int i = 0; i < 400; ++i) {
      pair.send();
      counts.push_back(pair.heard());
    }
    return counts;
  };
  const auto once = heard(1);
  EXPECT_NEAR(static_cast<double>(once.back()), 300.0, 30.0);
  EXPECT_EQ(heard(1), once);
  EXPECT_NE(heard(2), once);
}

TEST(SerialRadio, IsNotHeardOnAnotherChannelNorWhileDead) {
  Pair apart("channel = 1\n", "channel = 2\n");
  apart.send();
  apart.ticks(50);
  EXPECT_EQ(apart.heard(), 0u);
  Pair pair("", "");
  pair.b.fault("air", "dead", {});
  pair.send();
  pair.ticks(50);
  EXPECT_EQ(pair.heard(), 0u);
  pair.b.fault("air", "ok", {});
  pair.send();
  pair.ticks(50);
  EXPECT_EQ(pair.heard(), 1u);
}

TEST(SerialRadio, TakesTextOfAScript) {
  Pair pair("", "");
  pair.b.send("air", {"\xFF\xFF"}, pair.now + kTick);
  pair.ticks(5);
  EXPECT_EQ(pair.heard(), 2u);
}

TEST(SerialRadio, RefusesWhatCannotBe) {
  for (const char* keys : {"delay = \"0.5 ms\"", "delay = \"11 s\"", "loss = 1.1", "loss = -0.1",
                           "channel = 256", "baud = 100", "speed = 3"})
    EXPECT_THROW(parse_description(kBareRobot + radio(std::string(keys) + "\n"), "r.toml"), InputError)
        << keys;
}

}  // namespace serial_radio_test
}  // namespace robosim::robot
