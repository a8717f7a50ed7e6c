// Tests the detection of torn reads, torn writes and lost updates. An image that is built with --sanitize
// crashes at these accesses. In the image for the real robot, a detector finds them.

#include <array>

#include "tests/unit/detect_avr/fixture.h"

namespace robosim::detect {
namespace race_analysis_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class TearingTest : public AvrDetectorTest, public testing::WithParamInterface<bool> {
 protected:
  struct Torn {
    std::string kind, text;
    SourceLine where;
  };

  TearingTest() {
    sanitize_ = GetParam();
    watched_ = !sanitize_;
  }
  Torn torn() const {
    if (sanitize_ && avr_->crash())
      return {avr_->crash()->check, avr_->crash()->reason, avr_->crash()->where};
    EXPECT_FALSE(avr_->crash());
    for (const Detected& seen : avr_->detected())
      return {seen.detector, seen.what + ". " + seen.mend, seen.where};
    return {};
  }
};

INSTANTIATE_TEST_SUITE_P(In, TearingTest, testing::Bool(), [](const auto& test) {
  return test.param ? "AnImageWithChecks" : "TheImageThatIsFlashed";
});

/// Returns a sketch whose loop() executes `line`, and whose timer executes `handler` 20,000 times per second.
std::string pluralize(const std::string& line, const std::string& handler = "ticks += 40;") {
  return "#include <util/atomic.h>\n"
         "volatile unsigned long ticks; volatile bool ready; volatile unsigned long seen;\n"
         "ISR(TIMER2_COMPA_vect) { " +
         handler +
         " }\n"
         "void setup() { TCCR2A = _BV(WGM21); OCR2A = 99; TCCR2B = _BV(CS21); TIMSK2 = _BV(OCIE2A); }\n"
         "void loop() { " +
         line + " }\n";
}

TEST_P(TearingTest, ANumberThatAHandlerMayChangeWhileItIsRead) {
  start(pluralize("seen = ticks;"));
  run(100 * kMillisecond);
  const Torn found = torn();
  EXPECT_EQ(found.kind, "torn_read");
  EXPECT_THAT(found.text, HasSubstr("torn read of ticks, whose 4 bytes the chip reads one by one: "
                                    "the handler at Test.ino:3 changes them in an interrupt"));
  EXPECT_THAT(found.text, HasSubstr("opy it with interrupts off (noInterrupts(), ATOMIC_BLOCK)"));
  EXPECT_EQ(found.where.file, "Test.ino");
  EXPECT_EQ(found.where.line, 5);
  EXPECT_EQ(found.where.function, "loop");
}

TEST_P(TearingTest, ANumberThatIsReadWithInterruptsOffSometimesOnly) {
  start(pluralize("if (ready) noInterrupts(); seen = ticks; interrupts();"));
  run(100 * kMillisecond);
  EXPECT_EQ(torn().kind, "torn_read");
}

TEST_P(TearingTest, ANumberThatAHandlerChangesByAFunctionAndAPointer) {
  start("__attribute__((noinline)) void add(volatile unsigned long* to) { *to += 40; }\n" +
        pluralize("seen = ticks;", "add(&ticks);"));
  run(100 * kMillisecond);
  EXPECT_EQ(torn().kind, "torn_read");
}

TEST_P(TearingTest, ANumberThatAHandlerMayChangeWhileItIsWritten) {
  start(pluralize("if (++seen % 500 == 0) ticks = 0;", "ticks += 400;"));
  run(100 * kMillisecond);
  EXPECT_EQ(torn().kind, "torn_write");
  EXPECT_THAT(torn().text,
              AllOf(HasSubstr("torn write of ticks, whose 4 bytes the chip writes one by one: the handler at "
                              "Test.ino:3 changes them in an interrupt"),
                    HasSubstr("rite it with interrupts off"), Not(HasSubstr("opy it"))));
  EXPECT_EQ(torn().where.line, 5);
}

TEST_P(TearingTest, AByteThatAHandlerMayChangeWhileItIsChanged) {
  const std::array<std::string, 2> wrong[] = {
      {"flags |= 2; if (flags & 1) seen = 1; flags &= ~3;", "flags |= 1;"},
      {"if (flags) { --flags; ++seen; }", "++flags;"},
      {"flags = flags * 3 + 1;", "flags += 5;"}};
  for (const auto& [line, handler] : wrong) {
    start("volatile byte flags;\n" + pluralize(line, handler));
    run(100 * kMillisecond);
    EXPECT_EQ(torn().kind, "lost_update") << line;
    EXPECT_THAT(torn().text,
                HasSubstr("lost update of flags, which is read, changed and written back: the handler at "
                          "Test.ino:4 changes it in an interrupt"));
    EXPECT_THAT(torn().text, AllOf(HasSubstr("hange it with interrupts off"), Not(HasSubstr("opy it"))));
    EXPECT_EQ(torn().where.line, 6);
  }
}

TEST_P(TearingTest, AByteThatNoHandlersWriteIsUndoneOfIsNone) {
  const std::array<std::string, 2> right[] = {{"if (flags) { flags = 0; ++seen; }", "flags = 1;"},
                                              {"if (flags & 1) { flags &= ~1; ++seen; }", "flags |= 1;"},
                                              {"noInterrupts(); flags |= 2; interrupts();", "flags |= 1;"},
                                              {"ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { --flags; }", "++flags;"},
                                              {"GPIOR0 |= 2;", "GPIOR0 |= 1; flags = GPIOR0;"},
                                              {"flags |= 2;", "if (flags & 2) ++seen;"}};
  for (const auto& [line, handler] : right) {
    start("volatile byte flags;\n" + pluralize(line, handler));
    run(20 * kMillisecond);
    EXPECT_EQ(torn().text, "") << line;
  }
}

// Tests correct ways to share `ticks` with the handler. The handler runs as often as in the tests above.
TEST_P(TearingTest, ANumberThatNoHandlerCanTearIsNone) {
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
    start(pluralize(line, handler));
    run(20 * kMillisecond);  // 400 runs of the handler; 60 reveal the torn read above
    EXPECT_EQ(torn().text, "") << line;
  }
}

// tone() writes the number of pin changes, which has 4 bytes. Meanwhile, an interrupt handler of the core may
// still decrement this number for the previous tone.
TEST_P(TearingTest, WhatTheCoreDoesWithItsOwnNumbersIsNotTheSketchs) {
  start("void setup() {}\nvoid loop() { tone(11, 4000, 512); delayMicroseconds(random(1000)); }\n");
  run(500 * kMillisecond);
  EXPECT_EQ(torn().text, "");
}

TEST_P(TearingTest, IsNotLookedForUnlessSomebodyAsks) {
  if (sanitize_) return;
  avr_ = std::make_unique<exec::AvrExecutor>(*find_board(board_name_), build(pluralize("seen = ticks;")),
                                             make_detectors_);
  avr_->power_on(0);
  now_ = 0;
  run(100 * kMillisecond);
  EXPECT_EQ(torn().text, "");
}

}  // namespace race_analysis_test
}  // namespace robosim::detect
