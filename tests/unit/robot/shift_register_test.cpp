// Tests chains of 74HC595 shift registers, and parts on their outputs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace shift_register_test {

using testing::HasSubstr;

constexpr Pin kSer = 11, kSrclk = 13, kRclk = 10, kOe = 9;

const std::string kRegister = R"(
[[part]]
name = "REG1"
type = "shift-register"
pins = { data = 11, clock = 13, latch = 10 }
)";

const std::string kSecond = R"(
[[part]]
name = "REG2"
type = "shift-register"
after = "REG1"
)";

std::string led(const std::string& name, const std::string& pin) {
  return "\n[[part]]\nname = \"" + name + "\"\ntype = \"led\"\npin = \"" + pin + "\"\n";
}

std::string leds(const std::string& reg) {
  std::string parts;
  for (int q = 0; q < 8; ++q) parts += led(reg + "." + std::to_string(q), reg + ".Q" + std::to_string(q));
  return parts;
}

class RegisterBench : public BenchRobot {
 public:
  explicit RegisterBench(const std::string& parts, Profile profile = Profile::ideal, std::uint64_t seed = 1)
      : BenchRobot(parts, profile, seed) {
    for (const Pin pin : {kSer, kSrclk, kRclk}) board.output(pin, false, now);
  }

  void shift(unsigned bits, int count, SimTime t) {
    for (int i = count - 1; i >= 0; --i) {
      board.output(kSer, (bits >> i & 1) != 0, t);
      board.output(kSrclk, true, t);
      board.output(kSrclk, false, t);
    }
  }
  void latch(SimTime t) {
    board.output(kRclk, true, t);
    board.output(kRclk, false, t);
  }
  /// Returns the states of the LEDs on a register's outputs. Output Q0 is bit 0.
  unsigned shown(const std::string& reg) {
    unsigned bits = 0;
    for (const Reading& reading : robot.readings())
      if (reading.part.rfind(reg + ".", 0) == 0 && reading.value == 1.0)
        bits |= 1u << (reading.part.back() - '0');
    return bits;
  }
};

TEST(ShiftRegister, ShowsWhatWasShiftedInOnlyWhenItIsLatched) {
  RegisterBench bench(kRegister + leds("REG1"));
  bench.shift(0xA5, 8, 0);
  EXPECT_EQ(bench.shown("REG1"), 0u);
  bench.latch(0);
  EXPECT_EQ(bench.shown("REG1"), 0xA5u);
  bench.shift(0x3, 3, 0);
  EXPECT_EQ(bench.shown("REG1"), 0xA5u);
  bench.latch(0);
  EXPECT_EQ(bench.shown("REG1"), 0x2Bu) << "the other bits moved by three";
}

TEST(ShiftRegister, TheFirstByteEndsUpInTheLastRegisterOfTheChain) {
  RegisterBench bench(kSecond + leds("REG2") + kRegister + leds("REG1"));
  bench.shift(0x12, 8, 0);
  bench.shift(0x34, 8, 0);
  bench.latch(0);
  EXPECT_EQ(bench.shown("REG2"), 0x12u);
  EXPECT_EQ(bench.shown("REG1"), 0x34u);
}

TEST(ShiftRegister, FallingEdgesDoNothing) {
  RegisterBench bench(kRegister + leds("REG1"));
  bench.board.output(kSer, true, 0);
  bench.board.output(kSrclk, true, 0);
  bench.board.output(kRclk, true, 0);
  EXPECT_EQ(bench.shown("REG1"), 1u);
  bench.board.output(kSrclk, false, 0);
  bench.board.output(kRclk, false, 0);
  EXPECT_EQ(bench.shown("REG1"), 1u);
}

TEST(ShiftRegister, EnableHighSwitchesItsOutputsOff) {
  RegisterBench bench(
      "[[part]]\nname = \"REG1\"\ntype = \"shift-register\"\n"
      "pins = { data = 11, clock = 13, latch = 10, enable = 9 }\n" +
      leds("REG1"));
  bench.shift(0xFF, 8, 0);
  bench.latch(0);
  EXPECT_EQ(bench.shown("REG1"), 0xFFu);
  bench.board.output(kOe, true, 0);
  EXPECT_EQ(bench.shown("REG1"), 0u);
  bench.board.output(kOe, false, 0);
  EXPECT_EQ(bench.shown("REG1"), 0xFFu);
}

TEST(ShiftRegister, AMotorBehindItIsAveragedByTheExactTimesOfTheLatch) {
  RegisterBench bench(kRegister +
                      "[[part]]\nname = \"left\"\ntype = \"motor\"\n"
                      "pins = { in1 = \"REG1.Q6\", in2 = \"REG1.Q5\" }\n");
  bench.shift(0x40, 8, 100 * kMicrosecond);
  bench.latch(250 * kMicrosecond);
  bench.shift(0x20, 8, 300 * kMicrosecond);
  bench.latch(750 * kMicrosecond);
  bench.tick();
  EXPECT_NEAR(bench.robot.left_command(), 0.5 - 0.25, 1e-12);
  bench.tick();
  EXPECT_EQ(bench.robot.left_command(), -1.0);
}

TEST(ShiftRegister, HoldsAnythingAtPowerOnUnlessIdeal) {
  RegisterBench ideal(kRegister + leds("REG1"));
  EXPECT_EQ(ideal.shown("REG1"), 0u);
  unsigned seen_high = 0, seen_low = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RegisterBench typical(kRegister + leds("REG1"), Profile::typical, seed);
    seen_high |= typical.shown("REG1");
    seen_low |= ~typical.shown("REG1") & 0xFF;
  }
  EXPECT_EQ(seen_high, 0xFFu);
  EXPECT_EQ(seen_low, 0xFFu);
}

TEST(ShiftRegister, DrivesNothingAndForgetsWhileTheBoardHasNoSupply) {
  RegisterBench bench(kRegister + leds("REG1"));
  bench.shift(0xFF, 8, 0);
  bench.latch(0);
  bench.robot.power(false, 0);
  EXPECT_EQ(bench.shown("REG1"), 0u);
  bench.robot.power(true, 0);
  bench.latch(0);
  EXPECT_EQ(bench.shown("REG1"), 0u);
}

TEST(ShiftRegister, IsNamedInTheWiring) {
  const Description robot = parse_description(kBareRobot + kRegister + led("lamp", "REG1.Q4"), "r.toml");
  EXPECT_EQ(pin_text(robot, robot.parts[1]->wires[0].pin), "REG1.Q4");
  EXPECT_EQ(describe(robot).registers, std::vector<Register>{{"REG1"}});
}

std::string error_of(const std::string& parts) {
  try {
    parse_description(kBareRobot + parts, "r.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ShiftRegister, MistakesAreExplainedWithTheirLine) {
  const std::string chained = "[[part]]\nname = \"B\"\ntype = \"shift-register\"\nafter = ";
  EXPECT_THAT(error_of(kRegister + led("lamp", "REG7.Q1")),
              HasSubstr("pin: unknown shift register or PWM driver in \"REG7.Q1\": expected REG1"));
  EXPECT_THAT(error_of(led("lamp", "REG7.Q1")), HasSubstr("in \"REG7.Q1\": the robot has none"));
  EXPECT_THAT(error_of(kRegister + led("lamp", "REG1.Q8")),
              HasSubstr("expected an output of REG1, REG1.Q0 to REG1.Q7"));
  EXPECT_THAT(error_of(kRegister + led("lamp", "REG1.Q1") + led("other", "REG1.Q1")),
              HasSubstr("pin REG1.Q1 is already used by pin of lamp (r.toml:"));
  EXPECT_THAT(error_of(kRegister + "[[part]]\nname = \"b\"\ntype = \"button\"\npin = \"REG1.Q1\"\n"),
              HasSubstr("an output of a shift register"));
  EXPECT_THAT(error_of(kRegister + chained + "\"lamp\"\n"),
              HasSubstr("after: unknown shift register: expected REG1 or B, got “lamp”"));
  EXPECT_THAT(error_of(kRegister + kSecond + chained + "\"REG1\"\n"),
              HasSubstr("REG2 and B both follow REG1"));
  EXPECT_THAT(error_of(chained + "\"B\"\n"), HasSubstr("B follows itself in a circle"));
  EXPECT_THAT(error_of(chained + "\"C\"\n[[part]]\nname = \"C\"\ntype = \"shift-register\"\nafter = \"B\"\n"),
              HasSubstr("r.toml:19:9: B follows itself in a circle"));
  EXPECT_THAT(error_of(chained + "\"REG1\"\npins = { data = 2, clock = 3, latch = 4 }\n" + kRegister),
              HasSubstr("the key after excludes the key pins: B follows REG1 and shares its clock and "
                        "latch"));
  EXPECT_THAT(error_of("[[part]]\nname = \"B\"\ntype = \"shift-register\"\n"),
              HasSubstr("B requires either the key pins (data, clock, latch) or the key after"));
}

}  // namespace shift_register_test
}  // namespace robosim::robot
