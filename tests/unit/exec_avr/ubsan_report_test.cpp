// Tests the findings, and their messages, of a sketch that is built with `--sanitize` for target avr.

#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::ubsan_report_test {

class CheckTest : public AvrTest {
 protected:
  CheckTest() { sanitize_ = true; }
  /// Returns the crash of a sketch whose loop() executes `line`. The variable x is 600, and zero is 0.
  Crash crash_of(const std::string& line) {
    start(
        "volatile int x = 600, zero; volatile long big = 2000000000L; volatile float f = 40000.5;\n"
        "int table[5]; volatile unsigned u = 65535; volatile long l; volatile int n;\n"
        "void setup() {}\n"
        "void loop() {\n" +
        line + "\n}\n");
    run(10 * kMillisecond);
    return avr_->crash().value_or(Crash{});
  }
  void expect(const std::string& line, const std::string& check, const std::string& reason) {
    const Crash crash = crash_of(line);
    EXPECT_EQ(crash.check, check) << line;
    EXPECT_EQ(crash.reason, reason) << line;
    EXPECT_EQ(crash.where.file, "Test.ino") << line;
    EXPECT_EQ(crash.where.line, 5) << line;
    EXPECT_EQ(crash.where.function, "loop") << line;
  }
};

constexpr char kInt[] = " does not fit an int, which holds -32768 to 32767 here";

TEST_F(CheckTest, ANumberThatNoIntHolds) {
  expect("n = 1000 * x;", "mul_overflow", std::string("600 * 1000") + kInt);
  expect("n = -32000 - x - x;", "sub_overflow", std::string("-32600 - 600") + kInt);
}

TEST_F(CheckTest, ANumberThatNoLongHolds) {
  expect("l = big + big;", "add_overflow",
         "2000000000 + 2000000000 does not fit a long int, which holds -2147483648 to 2147483647 here");
}

TEST_F(CheckTest, AFloatThatNoIntHolds) {
  expect("n = f;", "float_cast_overflow", std::string("float 40000.5") + kInt);
}

TEST_F(CheckTest, AShiftAnIndexAndADivisor) {
  expect("l = 1 << (x / 30);", "shift_out_of_bounds",
         "a shift by 20 bits, but an int has 16 here: 0 to 15 are possible");
  expect("table[x / 100] = 1;", "out_of_bounds",
         "index 6 is outside of the array, an int [5]: valid indices are 0 to 4");
  expect("n = x % zero;", "divrem_overflow", "division by zero");
}

TEST_F(CheckTest, WhatIsAllowedIsNotFound) {
  EXPECT_EQ(
      crash_of("n = x << 8; n = -x << 2; ++u; l = 1000L * x; byte b = x; n = (int)millis(); n = b;").reason,
      "");
}

TEST_F(CheckTest, TheCallsThatAreOpenBeginInTheSketch) {
  const Crash crash = crash_of("n = 1000 * x;");
  ASSERT_FALSE(crash.calls.empty());
  EXPECT_EQ(crash.calls[0].function, "loop");
}

// The checks of `--sanitize` enlarge a program, so the emulated chip has more memory. The program of this
// test has 20 KB of variables and 40 KB of constants.
TEST_F(CheckTest, ThereIsMoreMemoryThanOnTheChipButNotForOthers) {
  const std::string large =
      "byte table[20000];\nconst PROGMEM byte one[20000] = {1}, two[20000] = {2};\nvolatile unsigned i = "
      "19999;\n"
      "void setup() { table[i] = pgm_read_byte(one + i) + pgm_read_byte(two + i); Serial.begin(9600); "
      "Serial.print(table[i]); }\n"
      "void loop() {}";
  EXPECT_EQ(output(large), "0");
  EXPECT_FALSE(avr_->resources()) << "with checks, the resources are not the sketch's";
  sanitize_ = false;
  EXPECT_THROW(build(large), InputError);
}

}  // namespace robosim::exec::ubsan_report_test
