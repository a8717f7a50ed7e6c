#include "sim/build/clock_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace clock_warnings_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string on(const char* board, const std::string& code) {
  return clock_warnings("#line 1 \"My.ino\"\n" + code + "\n", {"My.ino"}, *find_board(board));
}
std::string in(const std::string& code) { return on("uno", code); }

/// Returns a sketch whose loop() sets `since`, a variable of this type, to millis(), and then executes `use`.
std::string since_is(const std::string& type, const std::string& use) {
  return type + " since = 0;\nvoid loop() {\nsince = millis();\n" + use + "\n}";
}

TEST(ClockWarnings, ADifferenceFromATimeIn16BitsIsNamedWithItsLineTheMomentAndTheWayOut) {
  EXPECT_EQ(in(since_is("uint16_t", "if (millis() - since >= 5000) act();")),
            "My.ino:4: warning: 'millis() - since' is wrong from 65.536 s after power-on, because 'since' "
            "cannot exceed 65535: declare 'since' as unsigned long, or write (uint16_t)(millis() - since)");
}

TEST(ClockWarnings, TheMomentDependsOnTheTypeAndTheClock) {
  const std::string use = "while (millis() - since < 500) wait();";
  for (const char* type : {"unsigned int", "unsigned", "word", "volatile uint16_t", "static unsigned short",
                           "unsigned short int"})
    EXPECT_THAT(in(since_is(type, use)), HasSubstr("from 65.536 s")) << type;
  for (const char* type : {"int", "short", "int16_t", "signed int"})
    EXPECT_THAT(in(since_is(type, use)), HasSubstr("from 32.768 s")) << type;
  EXPECT_THAT(in(since_is("byte", use)), HasSubstr("from 0.256 s"));
  EXPECT_THAT(in(since_is("byte", use)), HasSubstr("write (uint8_t)(millis() - since)"));
  EXPECT_THAT(in("unsigned int t; void loop() { t = micros(); while (micros() - t < 100); }"),
              HasSubstr("'micros() - t' is wrong from 65.536 ms"));
}

TEST(ClockWarnings, AnIntHas16BitsOnAnAvrOnly) {
  const std::string use = "if (millis() - since >= 5000) act();";
  EXPECT_EQ(on("bluepill", since_is("int", use)), "");
  EXPECT_EQ(on("bluepill", since_is("unsigned int", use)), "");
  EXPECT_THAT(on("bluepill", since_is("uint16_t", use)), HasSubstr("from 65.536 s"));
  EXPECT_THAT(on("mega", since_is("int", use)), HasSubstr("from 32.768 s"));
}

TEST(ClockWarnings, FollowMembersElementsAndVariablesWithTheTime) {
  EXPECT_THAT(in("struct Timer { uint16_t since; };\nTimer t;\nvoid loop() { t.since = millis();\n"
                 "if (millis() - t.since > 5) act(); }"),
              StartsWith("My.ino:4: warning: 'millis() - t.since' is wrong"));
  EXPECT_THAT(in("class T { uint16_t since_ = 0; bool due() { return millis() - this->since_ > 5; }\n"
                 "void start() { since_ = millis(); } };"),
              HasSubstr("'millis() - this->since_' is wrong"));
  EXPECT_THAT(
      in("unsigned int last[3];\nvoid loop() { last[i] = millis(); if (millis() - last[i] > 5) f(); }"),
      HasSubstr("'millis() - last[i]' is wrong"));
  EXPECT_THAT(in("uint16_t last;\nvoid loop() { unsigned long now = millis();\n"
                 "if (now - last >= 20) { last = now; } }"),
              StartsWith("My.ino:3: warning: 'now - last' is wrong"));
  EXPECT_THAT(in("void loop() { static uint16_t a(millis()), b; b = a; if (5 <= millis() - b) f(); }"),
              HasSubstr("'millis() - b' is wrong"));
  EXPECT_THAT(in("uint16_t next = 0;\nvoid loop() { if (millis() - next >= P) { next += P; f(); } }"),
              HasSubstr("'millis() - next' is wrong"));
}

TEST(ClockWarnings, ADifferenceThatIsDividedOrStoredWithAllItsBitsIsWrong) {
  EXPECT_THAT(in(since_is("uint16_t", "float dt = (millis() - since) / 1000.0;")), HasSubstr("is wrong"));
  EXPECT_THAT(in(since_is("uint16_t", "unsigned long passed = millis() - since;")), HasSubstr("is wrong"));
  EXPECT_THAT(in(since_is("uint16_t", "rpm = ticks * 60000 / (millis() - since);")), HasSubstr("is wrong"));
  EXPECT_THAT(in(since_is("uint16_t", "if ((long)(millis() - since) >= 9) f();")), HasSubstr("is wrong"));
}

TEST(ClockWarnings, ATimeIn16BitsThatIsComparedWithTheClockIsNamed) {
  EXPECT_EQ(in("void loop() {\nint t = millis();\nwhile (millis() < t + 1000) wait();\n}"),
            "My.ino:3: warning: 'millis() < t + 1000' is wrong from 32.768 s after power-on, because 't' "
            "cannot exceed 32767: declare 't' as unsigned long");
  EXPECT_THAT(in("void f() { uint16_t until = millis() + 500; while (millis() < until) wait(); }"),
              HasSubstr("'millis() < until' is wrong from 65.536 s"));
  EXPECT_THAT(in("void f() { uint16_t t = millis(); if (ready && t + 9 <= millis()) act(); }"),
              HasSubstr("'t + 9 <= millis()' is wrong from 65.536 s"));
}

TEST(ClockWarnings, ADifferenceThatIsCutTo16BitsIsCorrect) {
  for (const char* use : {"if ((uint16_t)(millis() - since) >= 5000) act();",
                          "uint16_t now = millis(); if (now - since > 5) act();",
                          "if (uint16_t(millis() - since) >= 5000) act();",
                          "if (static_cast<unsigned int>(millis() - since) >= 5000) act();",
                          "if ((word)millis() - since >= 5000) act();",
                          "uint16_t passed = millis() - since; if (passed > 9) act();",
                          "unsigned int passed; passed = millis() - since;", "show(millis() - since);",
                          "uint16_t left = 5000 - (millis() - since);"})
    EXPECT_EQ(in(since_is("uint16_t", use)), "") << use;
}

TEST(ClockWarnings, AVariableWithAllBitsOrAShadowIsCorrect) {
  const std::string use = "if (millis() - since >= 5000) act();";
  for (const char* type : {"unsigned long", "uint32_t", "long", "unsigned long long", "float", "Clock::time"})
    EXPECT_EQ(in(since_is(type, use)), "") << type;
  EXPECT_EQ(in("uint16_t since;\nvoid loop() { unsigned long since = millis();\n" + use + "}"), "");
  EXPECT_EQ(in("uint16_t since = millis();\nvoid f(unsigned long since) {" + use + "}"), "");
  EXPECT_EQ(in("uint16_t since = millis();\ntemplate <typename T> void f(T since) {" + use + "}"), "");
  EXPECT_EQ(in("uint16_t since = millis();\nvoid f() { Duration<long> since; " + use + "}"), "");
  EXPECT_EQ(in("struct A { uint16_t since; }; struct B { unsigned long since; };\n"
               "void f() { a.since = b.since = millis(); if (millis() - b.since > 9) act(); }"),
            "");
}

TEST(ClockWarnings, WhatIsNoTimeIsCorrect) {
  EXPECT_EQ(in("const int offset = 500;\nvoid loop() { if (millis() - offset > 9) act(); }"), "");
  EXPECT_EQ(in("uint16_t paused;\nvoid f() { paused = millis() - start; start = millis() - paused;\n"
               "if (millis() - paused > 9) act(); }"),
            "");
  EXPECT_EQ(in("uint16_t period = 500;\nvoid loop() { if (millis() > period) act(); period += 5; }"), "");
  EXPECT_EQ(in("uint16_t s = millis() / 1000;\nvoid loop() { if (millis() / 1000 - s > 5) act(); }"), "");
  EXPECT_EQ(in("uint16_t since = millis();\nvoid f() { log(\"millis() - since > 5\"); }"), "");
  EXPECT_EQ(in("uint16_t since = millis();\nvoid f() { if (clock.millis() - since > 5) act(); }"), "");
  EXPECT_EQ(in("uint16_t since() { return 5; }\nvoid f() { if (millis() - since() > 5) act(); }"), "");
}

TEST(ClockWarnings, AMemberOfALibrarysClassWithTheSameNameLeavesADoubt) {
  const std::string own =
      "#line 1 \"My.ino\"\n" + since_is("uint16_t", "if (millis() - since > 5) act();") + "\n";
  const auto with = [&](const std::string& header) {
    return clock_warnings("# 1 \"Lib.h\"\n" + header + "\n" + own, {"My.ino"}, *find_board("uno"));
  };
  EXPECT_EQ(with("class Lib { unsigned long since; };"), "");
  EXPECT_THAT(with("void wait(unsigned long since);"), HasSubstr("is wrong"));
}

TEST(ClockWarnings, AHostileSourceTakesLinearTime) {
  const auto repeated = [](const std::string& text) {
    std::string all;
    for (int i = 0; i < 5'000; ++i) all += text;
    return all;
  };
  for (const char* text :
       {"int a; ", "a<", "a b = ", "{(", "a + ", "int a = b; ", "if (millis() - a > 5) a += "})
    EXPECT_EQ(in(repeated(text)), "") << text;
}

class ClockWarningsOf : public SketchTest {};

TEST_F(ClockWarningsOf, ASketchNameItsHeadersAndComeFromTheCacheAgain) {
  write("My/Timer.h",
        "struct Timer {\n  uint16_t since;\n  bool due() { return millis() - since >= 500; }\n};\n");
  write("My/My.ino",
        "#include \"Timer.h\"\nTimer timer;  // millis() - since\nvoid setup() { timer.since = millis(); }\n"
        "void loop() {}\n");
  const std::string expected = "Timer.h:3: warning: 'millis() - since' is wrong from 65.536 s after power-on";
  EXPECT_THAT(build_here("My").messages, StartsWith(expected));
  const Image again = build_here("My");
  EXPECT_TRUE(again.from_cache);
  EXPECT_THAT(again.messages, StartsWith(expected));
  EXPECT_THAT(build({folder_ / "My", *find_board("uno"), "avr"}).messages, StartsWith(expected));
}

}  // namespace clock_warnings_test
}  // namespace robosim::build
