// Tests the detection of torn reads, torn writes and lost updates. An image that is built with `--sanitize`
// crashes at these accesses. In the image for the real robot, a detector finds them.

#include <array>

#include "tests/unit/detect_avr/fixture.h"

namespace robosim::detect::race_analysis_test {

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

// Tests correct ways to share `ticks` with the handler.
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
    run(20 * kMillisecond);  // the handler runs 400 times; a torn read would be found within 60 runs
    EXPECT_EQ(torn().text, "") << line;
  }
}

/// A sketch whose loop() shares a number with a handler.
struct Sharing {
  std::string number;  ///< the number's name in the finding; empty if nothing is found
  std::string declarations, line, handler;
};
std::string sketch_of(const Sharing& sharing) {
  return sharing.declarations + "\n" + pluralize(sharing.line, sharing.handler);
}

/// Lines 1 to 7 of a sketch.
const std::string kWheel =
    "struct Wheel {\n"
    "  __attribute__((noinline)) void tick() { count_ += 40; }\n"
    "  __attribute__((noinline)) long read() const { return count_; }\n"
    "  __attribute__((noinline)) void set(long to) { count_ = to; }\n"
    "  long inlined() const { return count_; }\n"
    "  byte pins[2]; volatile long count_;\n"
    "};\n";

TEST_P(TearingTest, AMemberThatAHandlerMayChangeWhileAMethodReadsIt) {
  start(
      sketch_of({"", kWheel + "Wheel left, right;", "seen = left.read() + right.read();", "right.tick();"}));
  run(100 * kMillisecond);
  EXPECT_EQ(torn().kind, "torn_read");
  EXPECT_THAT(torn().text,
              HasSubstr("torn read of right.count_, whose 4 bytes the chip reads one by one: the "
                        "handler at Test.ino:2 changes them in an interrupt"));
  EXPECT_EQ(torn().where.function, "read");
  EXPECT_EQ(torn().where.line, 3);
}

TEST_P(TearingTest, AMemberOrElementThatAHandlerMayChangeWhileItIsRead) {
  const Sharing wrong[] = {{"left.count_", kWheel + "Wheel left;", "seen = left.inlined();", "left.tick();"},
                           {"wheels[1].count_", kWheel + "Wheel wheels[2];",
                            "for (Wheel& wheel : wheels) seen += wheel.inlined();", "wheels[1].tick();"},
                           {"counts[1]", "volatile long counts[2];", "seen = counts[1];", "counts[1] += 40;"},
                           {"counts[2]", "volatile unsigned counts[3]; volatile byte i;",
                            "seen = counts[i]; i = (i + 1) % 3;", "counts[2] += 40;"},
                           {"grid[1][2]", "volatile unsigned grid[2][3]; volatile byte i;",
                            "seen = grid[i][2]; i ^= 1;", "grid[1][2] += 40;"},
                           {"pose.at.y", "struct { byte id; struct { volatile float x, y; } at; } pose;",
                            "seen = pose.at.y;", "pose.at.y += 1.7f;"}};
  for (const Sharing& each : wrong) {
    start(sketch_of(each));
    run(100 * kMillisecond);
    EXPECT_THAT(torn().text, HasSubstr("torn read of " + each.number + ", whose ")) << each.line;
  }
}

TEST_P(TearingTest, ANumberThatAHandlerMayChangeWhileAPointerReadsIt) {
  const std::string kRead =
      "struct To { __attribute__((noinline)) static long read(volatile long* from) { "
      "return *from; } };\n";
  const Sharing wrong[] = {
      {"ticks", "", "volatile unsigned long* volatile from = &ticks; seen = *from;", "ticks += 40;"},
      {"other", kRead + "volatile long other;", "seen = To::read(&other);", "other += 40;"},
      {"both.y", "struct Both { byte id; volatile unsigned x, y; } both; Both* volatile one = &both;",
       "seen = one->y;", "both.y += 40;"},
      {"d.count",
       "struct B { virtual long get() = 0; }; struct D : B { volatile long count; long get() override { "
       "return count; } } d; B* volatile one = &d;",
       "seen = one->get();", "d.count += 40;"}};
  for (const Sharing& each : wrong) {
    start(sketch_of(each));
    run(100 * kMillisecond);
    EXPECT_THAT(torn().text, HasSubstr("torn read of " + each.number + ", whose ")) << each.line;
  }
}

TEST_P(TearingTest, AMemberOrElementThatAHandlerMayChangeWhileItIsWritten) {
  const Sharing wrong[] = {
      {"left.count_", kWheel + "Wheel left;", "if (++seen % 500 == 0) left.set(0);", "left.count_ += 400;"},
      {"counts[1]", "volatile unsigned counts[2]; volatile byte i;",
       "if (++seen % 500 == 0) { counts[i] = 0; i ^= 1; }", "counts[1] += 400;"}};
  for (const Sharing& each : wrong) {
    start(sketch_of(each));
    run(100 * kMillisecond);
    EXPECT_THAT(torn().text, HasSubstr("torn write of " + each.number + ", whose ")) << each.line;
  }
}

TEST_P(TearingTest, AByteOfAnObjectThatAHandlerMayChangeWhileItIsChanged) {
  const std::string kLess =
      "struct To { __attribute__((noinline)) static void less(volatile byte& of) { --of; } };\n";
  const Sharing wrong[] = {{"state.flags", "struct { int id; volatile byte flags; } state;",
                            "state.flags ^= 64;", "++state.flags;"},
                           {"full", kLess + "volatile byte full;", "To::less(full);", "++full;"}};
  for (const Sharing& each : wrong) {
    start(sketch_of(each));
    run(100 * kMillisecond);
    EXPECT_THAT(torn().text, HasSubstr("lost update of " + each.number + ", which ")) << each.line;
  }
}

// Tests correct ways to share members, elements and pointers with the handler.
TEST_P(TearingTest, AMemberOrElementThatNoHandlerCanTearIsNone) {
  const std::string kLeft = kWheel + "Wheel left; ";
  const std::string kCounts = "volatile long counts[3]; volatile byte i; ";
  const Sharing right[] = {
      {"", kLeft, "noInterrupts(); seen = left.read(); interrupts();", "left.tick();"},
      {"", kLeft, "byte old = SREG; cli(); seen = left.read(); SREG = old;", "left.tick();"},
      {"", kLeft, "ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { seen = left.inlined(); }", "left.tick();"},
      {"", kCounts, "noInterrupts(); seen = counts[i]; interrupts(); i = (i + 1) % 3;", "counts[2] += 40;"},
      {"", kLeft, "TIMSK2 = 0; seen = left.read(); TIMSK2 = _BV(OCIE2A);", "left.tick();"},
      {"", kLeft, "long a, b; do { a = left.read(); b = left.read(); } while (a != b); seen = a;",
       "left.tick();"},
      {"", kLeft,
       "long now, again = left.read(); do { now = again; again = left.read(); } while (now != again); "
       "seen = now;",
       "left.tick();"},
      {"", kCounts,
       "byte k = i; long a, b; do { a = counts[k]; b = counts[k]; } while (a != b); seen = a; "
       "i = (k + 1) % 3;",
       "counts[2] += 40;"},
      {"", kCounts, "seen = counts[i]; i = (i + 1) % 3;", "counts[2] = (counts[2] + 1) & 0x7F;"},
      {"", "struct S { volatile bool full; volatile long x; } s; S* volatile to = &s;",
       "S* p = to; if (p->full) { seen = p->x; p->full = false; }",
       "if (!s.full) { s.x += 777; s.full = true; }"},
      {"", kCounts + "volatile byte head, tail;",
       "while (tail != head) { seen = counts[tail]; tail = (tail + 1) % 3; }",
       "byte next = (head + 1) % 3; if (next != tail) { counts[head] += 777; head = next; }"},
      {"", kLeft + "struct Car { __attribute__((noinline)) static long read() { return left.read(); } };",
       "long a, b; do { a = Car::read(); b = Car::read(); } while (a != b); seen = a;", "left.tick();"},
      {"", kLeft, "left.tick(); seen = left.read();", "ticks += 777;"}};
  for (const Sharing& each : right) {
    start(sketch_of(each));
    run(20 * kMillisecond);
    EXPECT_EQ(torn().text, "") << each.line;
  }
}

TEST_P(TearingTest, BytesOfSeveralVariablesAreNotOneNumber) {
  const Sharing right[] = {
      {"", "struct S { volatile byte a; unsigned b; } s; S* volatile to = &s;",
       "S* p = to; byte a = p->a, low = *(volatile byte*)&p->b; seen = a + low;", "s.a += 40; s.b += 400;"},
      {"", "struct S { volatile byte a, b, c; } s; S* volatile to = &s;",
       "S* p = to; seen = p->a + p->b + p->c;", "s.a += 40; s.b += 3; ++s.c;"},
      {"", "volatile byte bytes[8]; volatile byte i;", "seen = bytes[i] + bytes[i + 1]; i ^= 2;",
       "for (byte& each : (byte(&)[8])bytes) each += 40;"},
      {"", "struct S { volatile byte a; volatile unsigned b; } s; S* volatile to = &s;",
       "S* p = to; seen = p->a; seen += p->b;", "s.a += 40;"},
      {"", "volatile unsigned words[3]; volatile byte i;", "seen = words[1 + i];",
       "words[0] += 40; words[2] += 400;"},
      {"", "char text[12] = \"abc\"; char copy[12]; volatile byte i;",
       "memcpy(copy, text, sizeof copy); seen = copy[i] + text[i + 1];", "text[0] ^= 1; text[1] ^= 1;"},
      {"", "byte from[16], to[16]; volatile byte i;", "memcpy(to, from, sizeof to); seen = to[i];",
       "ticks += 777;"},
      {"", "", "seen = TCNT1; OCR1A = TCNT1; seen += ICR1;", "ticks = TCNT1; OCR1B = ticks;"}};
  for (const Sharing& each : right) {
    start(sketch_of(each));
    run(20 * kMillisecond);
    EXPECT_EQ(torn().text, "") << each.line;
  }
}

TEST_P(TearingTest, AReadThatIsRepeatedIfAHandlerRanIsNone) {
  const Sharing right[] = {
      {"", "volatile byte runs;", "byte run; do { run = runs; seen = ticks; } while (run != runs);",
       "++runs; ticks += 777;"},
      {"", "", "do { ready = false; seen = ticks; } while (ready);", "ready = true; ticks += 777;"},
      {"",
       "struct { volatile byte runs; volatile long x; __attribute__((noinline)) long read() { byte run; long "
       "now; do { run = runs; now = x; } while (run != runs); return now; } } s;",
       "seen = s.read();", "++s.runs; s.x += 777;"}};
  for (const Sharing& each : right) {
    start(sketch_of(each));
    run(20 * kMillisecond);
    EXPECT_EQ(torn().text, "") << each.line;
  }
  start(pluralize("while (ready) seen = ticks;", "ready = true; ticks += 777;"));
  run(20 * kMillisecond);
  EXPECT_EQ(torn().kind, "torn_read") << "the loop does not repeat a torn read";
  start("volatile byte runs;\n" +
        pluralize("byte run; do { run = runs; seen = ticks; } while (run != runs);", "ticks += 777;"));
  run(20 * kMillisecond);
  EXPECT_EQ(torn().kind, "torn_read") << "the handler does not change the byte";
}

TEST_P(TearingTest, NamesTheFunctionThatAnInterruptCalls) {
  start(kWheel +
        "Wheel left; long seen;\n"
        "void pulse() { for (byte i = 0; i < 9; ++i) left.tick(); }\n"
        "void setup() { attachInterrupt(0, pulse, RISING); }\n"
        "void loop() { seen = left.read(); }\n");
  for (int i = 0; i < 100; ++i) {
    board().schedule_edge(2, true, now_ + 300 * kMicrosecond);
    board().schedule_edge(2, false, now_ + 500 * kMicrosecond);
    run(kMillisecond);
  }
  EXPECT_THAT(torn().text, HasSubstr("tick at Test.ino:2, called by the handler pulse, changes them"));
}

TEST_P(TearingTest, IsReportedOncePerNumberAndLine) {
  if (sanitize_) return;  // a run ends at its first finding
  start("volatile long counts[3]; volatile long other; byte rounds;\n" +
        pluralize("for (byte i = 0; i < 3; ++i) seen += counts[i];\n if (++rounds == 0) seen += other;",
                  "for (byte i = 0; i < 3; ++i) counts[i] += 40;\n other += 40;"));
  run(200 * kMillisecond);
  ASSERT_EQ(avr_->detected().size(), 2u);
  EXPECT_NE(avr_->detected()[0].where.line, avr_->detected()[1].where.line);
}

// tone() writes the number of pin changes, which has 4 bytes. Meanwhile, an interrupt handler of the Arduino
// core may still decrement this number for the previous tone.
TEST_P(TearingTest, WhatTheCoreDoesWithItsOwnNumbersIsNotTheSketchs) {
  start("void setup() {}\nvoid loop() { tone(11, 4000, 512); delayMicroseconds(random(1000)); }\n");
  run(500 * kMillisecond);
  EXPECT_EQ(torn().text, "");
}

TEST_P(TearingTest, IsNotLookedForUnlessSomebodyAsks) {
  if (sanitize_) return;
  watched_ = false;
  start(pluralize("seen = ticks;"));
  run(100 * kMillisecond);
  EXPECT_EQ(torn().text, "");
}

}  // namespace robosim::detect::race_analysis_test
