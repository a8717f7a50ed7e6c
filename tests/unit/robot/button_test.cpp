// Tests push buttons: levels, pull-ups, bouncing and faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/base/error.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace button_test {

std::string button(const std::string& keys) {
  return "[[part]]\nname = \"start\"\ntype = \"button\"\npin = 4\n" + keys;
}

TEST(Button, ActiveLowPullsThePinDown) {
  BenchRobot bench(button("resistor = true\n"));
  EXPECT_TRUE(bench.level(4));
  bench.robot.press("start", 500);
  EXPECT_TRUE(bench.board.read_level(4, 499));
  EXPECT_FALSE(bench.board.read_level(4, 500));
  bench.robot.release("start", 1000);
  EXPECT_FALSE(bench.board.read_level(4, 999));
  EXPECT_TRUE(bench.board.read_level(4, 1000));
}

TEST(Button, ActiveHighPullsThePinUp) {
  BenchRobot bench(button("active = \"high\"\n"));
  EXPECT_FALSE(bench.level(4));
  bench.robot.press("start", 0);
  EXPECT_TRUE(bench.level(4));
}

TEST(Button, WithoutAResistorItNeedsThePullUp) {
  BenchRobot bench(button(""));
  EXPECT_FALSE(bench.level(4)) << "a floating pin reads low in the ideal profile";
  bench.board.input(4, true, 0);
  EXPECT_TRUE(bench.level(4));
}

TEST(Button, AFloatingPinReadsAtRandomInTheTypicalProfile) {
  BenchRobot bench(button(""), Profile::typical);
  int high = 0;
  for (int ms = 0; ms < 1000; ++ms) high += bench.board.read_level(4, ms * kMillisecond);
  EXPECT_THAT(high, ::testing::AllOf(::testing::Gt(400), ::testing::Lt(600)));
  EXPECT_EQ(bench.board.read_level(4, 5 * kMillisecond), bench.board.read_level(4, 5 * kMillisecond + 900));
}

TEST(Button, KeepsWhatItPromises) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    BenchRobot bench(button("resistor = true\nbounce = \"2 ms\"\n"), Profile::typical, seed);
    bench.robot.press("start", 500 * kMicrosecond);
    for (SimTime t = 0, until = 0; t < 3 * kMillisecond; t += kMicrosecond) {
      const bool level = bench.board.read_level(4, t);
      const bool promised = t < until;
      EXPECT_TRUE(!promised || level == bench.board.read_level(4, t - kMicrosecond)) << "seed " << seed;
      until = bench.board.same_until(4, t);
      EXPECT_GT(until, t);
    }
    EXPECT_EQ(bench.board.same_until(4, 3 * kMillisecond), kNever);
  }
}

TEST(Button, PromisesNothingOfAFloatingPin) {
  BenchRobot bench(button(""), Profile::typical);
  EXPECT_EQ(bench.board.same_until(4, 5), 5);
  bench.board.input(4, true, 0);
  EXPECT_EQ(bench.board.same_until(4, 5), kNever);
}

TEST(Button, BouncesInTheTypicalProfileAndSettles) {
  int bounced = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    BenchRobot bench(button("resistor = true\nbounce = \"2 ms\"\n"), Profile::typical, seed);
    bench.robot.press("start", 0);
    int changes = 0;
    bool level = true;
    for (SimTime t = 0; t < 2 * kMillisecond; t += kMicrosecond)
      if (bench.board.read_level(4, t) != level) level = !level, ++changes;
    EXPECT_EQ(changes % 2, 1) << "the button ends up pressed";
    EXPECT_FALSE(bench.board.read_level(4, 2 * kMillisecond));
    bounced += changes > 1;
  }
  EXPECT_GT(bounced, 10);
}

TEST(Button, InterruptsSeeTheEdgesThatReadsSee) {
  BenchRobot bench(button("resistor = true\nbounce = \"3 ms\"\n"), Profile::typical, 3);
  bench.board.edges_wanted = true;
  bench.tick();
  bench.robot.press("start", bench.now);
  bench.robot.begin_tick(bench.now);
  bench.ticks(4);
  ASSERT_FALSE(bench.board.edges.empty());
  EXPECT_TRUE(std::is_sorted(bench.board.edges.begin(), bench.board.edges.end(),
                             [](const auto& a, const auto& b) { return a.at < b.at; }));
  for (const auto& edge : bench.board.edges) EXPECT_EQ(bench.board.read_level(4, edge.at), edge.level);
}

TEST(Button, FaultsHoldItsContact) {
  BenchRobot bench(button("resistor = true\n"));
  bench.robot.fault("start", "pressed", {});
  EXPECT_FALSE(bench.level(4));
  bench.robot.fault("start", "released", {});
  bench.robot.press("start", 0);
  EXPECT_TRUE(bench.level(4));
  bench.robot.fault("start", "ok", {});
  EXPECT_FALSE(bench.level(4));
}

TEST(Button, AnUnknownNameListsTheButtons) {
  BenchRobot bench(button(""));
  try {
    bench.robot.check_press("stop");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("unknown button of robot “"));
  }
}

TEST(Indicator, LedsAndBuzzersShowWhatTheirPinsDo) {
  BenchRobot bench(R"([[part]]
name = "LED"
type = "led"
pin = 13
[[part]]
name = "red"
type = "led"
pin = 9
active = "low"
[[part]]
name = "buzzer"
type = "buzzer"
pin = 11
)");
  const auto value = [&](std::size_t i) { return bench.robot.readings().at(i).value; };
  EXPECT_EQ(value(0), 0.0);
  EXPECT_EQ(value(1), 0.0) << "an LED on an undriven pin is off";
  bench.board.output(13, true, 0);
  bench.board.pwm(9, 0.25, 0);
  bench.board.output(11, true, 0);
  EXPECT_EQ(value(0), 1.0);
  EXPECT_EQ(value(1), 0.75);
  EXPECT_EQ(value(2), 0.0) << "a passive buzzer is silent on a constant level";
  PinDrive tone{PinMode::output};
  tone.tone_hz = 440;
  bench.board.set_drive(11, tone, 0);
  EXPECT_EQ(value(2), 440.0);
}

TEST(Buzzer, HasThePitchAtWhichItsPinToggles) {
  BenchRobot bench("[[part]]\nname = \"buzzer\"\ntype = \"buzzer\"\npin = 11\n");
  for (int ms = 0; ms < 20; ++ms) {  // toggles the pin at 1 kHz
    bench.board.output(11, true, bench.now);
    bench.board.output(11, false, bench.now + kTick / 2);
    bench.tick();
  }
  EXPECT_NEAR(bench.robot.readings().at(0).value, 1000.0, 1e-9);
  bench.ticks(60);
  EXPECT_EQ(bench.robot.readings().at(0).value, 0.0);
}

TEST(Voltage, IsAShareOfTheBattery) {
  BenchRobot bench("[[part]]\nname = \"battery\"\ntype = \"voltage\"\npin = \"A6\"\nshare = 0.5\n");
  EXPECT_DOUBLE_EQ(bench.volts(20), 3.0);
}

}  // namespace button_test
}  // namespace robosim::robot
