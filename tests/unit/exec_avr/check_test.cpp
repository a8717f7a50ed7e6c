// What the checks of a sketch built with --sanitize find on the chip, and how they say it.

#include <array>

#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace {

using testing::HasSubstr;

class CheckTest : public AvrTest {
 protected:
  CheckTest() { sanitize_ = true; }
  /// `line` is the second of loop(), where x is 600 and zero is 0.
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
         "a shift by 20 bits, and an int has 16 here: 0 to 15 are possible");
  expect("table[x / 100] = 1;", "out_of_bounds",
         "index 6 is outside of the array, an int [5]: its first is 0 and its last 4");
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

// Checks take more than the chip has: this program has 20 KB of variables and 40 KB of code.
TEST_F(CheckTest, ThereIsMoreMemoryThanOnTheChipButNotForOthers) {
  const std::string large =
      "byte table[20000];\nconst PROGMEM byte one[20000] = {1}, two[20000] = {2};\nvolatile unsigned i = "
      "19999;\n"
      "void setup() { table[i] = pgm_read_byte(one + i) + pgm_read_byte(two + i); Serial.begin(9600); "
      "Serial.print(table[i]); }\n"
      "void loop() {}";
  EXPECT_EQ(output(large), "0");
  EXPECT_FALSE(avr_->resources()) << "they are not those of the sketch";
  sanitize_ = false;
  EXPECT_THROW(build(large), InputError);
}

// --- torn reads and writes

/// A timer counts 20,000 times a second, and loop() is `line`.
std::string counted(const std::string& line, const std::string& handler = "ticks += 40;") {
  return "#include <util/atomic.h>\n"
         "volatile unsigned long ticks; volatile bool ready; volatile unsigned long seen;\n"
         "ISR(TIMER2_COMPA_vect) { " +
         handler +
         " }\n"
         "void setup() { TCCR2A = _BV(WGM21); OCR2A = 99; TCCR2B = _BV(CS21); TIMSK2 = _BV(OCIE2A); }\n"
         "void loop() { " +
         line + " }\n";
}

TEST_F(CheckTest, ANumberThatAHandlerMayChangeWhileItIsRead) {
  start(counted("seen = ticks;"));
  run(100 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_EQ(avr_->crash()->check, "torn_read");
  EXPECT_THAT(avr_->crash()->reason, HasSubstr("torn read of ticks, whose 4 bytes the chip reads one by one: "
                                               "the handler at Test.ino:3 changes them in an interrupt"));
  EXPECT_THAT(avr_->crash()->reason, HasSubstr("copy it with interrupts off (noInterrupts(), ATOMIC_BLOCK)"));
  EXPECT_EQ(avr_->crash()->where.file, "Test.ino");
  EXPECT_EQ(avr_->crash()->where.line, 5);
  EXPECT_EQ(avr_->crash()->where.function, "loop");
}

TEST_F(CheckTest, ANumberThatAHandlerMayChangeWhileItIsWritten) {
  start(counted("if (++seen % 500 == 0) ticks = 0;", "ticks += 400;"));
  run(100 * kMillisecond);
  ASSERT_TRUE(avr_->crash());
  EXPECT_EQ(avr_->crash()->check, "torn_write");
  EXPECT_EQ(avr_->crash()->where.line, 5);
}

TEST_F(CheckTest, AByteThatAHandlerMayChangeWhileItIsChanged) {
  const std::array<std::string, 2> wrong[] = {
      {"flags |= 2; if (flags & 1) seen = 1; flags &= ~3;", "flags |= 1;"},
      {"if (flags) { --flags; ++seen; }", "++flags;"},
      {"flags = flags * 3 + 1;", "flags += 5;"}};
  for (const auto& [line, handler] : wrong) {
    start("volatile byte flags;\n" + counted(line, handler));
    run(100 * kMillisecond);
    ASSERT_TRUE(avr_->crash()) << line;
    EXPECT_EQ(avr_->crash()->check, "lost_update");
    EXPECT_THAT(avr_->crash()->reason,
                HasSubstr("lost update of flags, which is read, changed and written back: the handler at "
                          "Test.ino:4 changes it in an interrupt"));
    EXPECT_EQ(avr_->crash()->where.line, 6);
  }
}

TEST_F(CheckTest, AByteThatNoHandlersWriteIsUndoneOfIsNone) {
  const std::array<std::string, 2> right[] = {{"if (flags) { flags = 0; ++seen; }", "flags = 1;"},
                                              {"if (flags & 1) { flags &= ~1; ++seen; }", "flags |= 1;"},
                                              {"noInterrupts(); flags |= 2; interrupts();", "flags |= 1;"},
                                              {"ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { --flags; }", "++flags;"},
                                              {"GPIOR0 |= 2;", "GPIOR0 |= 1; flags = GPIOR0;"},
                                              {"flags |= 2;", "if (flags & 2) ++seen;"}};
  for (const auto& [line, handler] : right) {
    start("volatile byte flags;\n" + counted(line, handler));
    run(20 * kMillisecond);
    EXPECT_FALSE(avr_->crash()) << line << "\n" << avr_->crash()->reason;
  }
}

// As people do it who know better; the handler comes as often.
TEST_F(CheckTest, ANumberThatNoHandlerCanTearIsNone) {
  const std::string kHandsOver = "if (!ready) { ticks = ticks + 777; ready = true; }";
  const std::array<std::string, 2> right[] = {
      {"noInterrupts(); seen = ticks; interrupts();", "ticks += 40;"},
      {"ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { seen = ticks; }", "ticks += 40;"},
      {"TIMSK2 = 0; seen = ticks; TIMSK2 = _BV(OCIE2A);", "ticks += 40;"},
      {"unsigned long now, again = ticks; do { now = again; again = ticks; } while (now != again); seen = "
       "now;",
       "ticks += 40;"},
      {"unsigned long now; do { now = ticks; } while (now != ticks); seen = now;", "ticks += 40;"},
      {"if (ready) { seen = ticks; ready = false; }", kHandsOver},
      {"seen = ticks;", "ticks = (ticks + 1) & 0x7F;"},
      {"seen = ticks;", "ready = !ready;"}};
  for (const auto& [line, handler] : right) {
    start(counted(line, handler));
    run(20 * kMillisecond);  // 400 handlers; the torn read above is found within 60
    EXPECT_FALSE(avr_->crash()) << line << "\n" << avr_->crash()->reason;
  }
}

TEST_F(CheckTest, TearingIsLookedForInImagesWithChecksOnly) {
  sanitize_ = false;
  start(counted("seen = ticks;"));
  run(100 * kMillisecond);
  EXPECT_FALSE(avr_->crash());
}

}  // namespace
}  // namespace robosim::exec
