#include "sim/build/condition_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace robosim::build {
namespace condition_warnings_test {

using ::testing::HasSubstr;

std::string in(const std::string& code) { return condition_warnings("#line 1 \"My.ino\"\n" + code + "\n"); }
std::string of(const std::string& condition) { return in("void loop() {\nif (" + condition + ") f();\n}"); }

TEST(ConditionWarnings, NameAValueThatWouldHaveToBeTwoAtOnce) {
  EXPECT_EQ(of("(s[0]==0)&&(s[4]==1)&&(s[4]==0)"),
            "My.ino:2: warning: 's[4]' cannot be 1 and 0 at once, so this condition is never true");
  for (const char* condition :
       {"digitalRead(2) == 0x1 && digitalRead(2) == 0x0", "a && x == 1 && b && 2 == x",
        "a || x == 1 && b && x == 0", "f(1) && (a && x == 1 && x == 2)",
        "a && (m.state == 1) && (m.state == 0)", "x == true && y && x == false"})
    EXPECT_THAT(of(condition), HasSubstr("at once, so this condition is never true")) << condition;
  EXPECT_THAT(in("bool f() { return a && x == 1 && x == 0; }"), HasSubstr("never true"));
  EXPECT_THAT(in("const int BLACK = 1, WHITE = 0;\nvoid loop() { if (a && s == BLACK && s == WHITE) f(); }"),
              HasSubstr("'s' cannot be 1 and 0 at once"));
}

TEST(ConditionWarnings, NameAValueThatIsComparedTwiceWithTheSame) {
  EXPECT_EQ(of("s[0] == 0 && s[4] == 0 && s[4] == 0"),
            "My.ino:2: warning: 's[4]' is compared with 0 twice in this condition: is another one meant?");
}

TEST(ConditionWarnings, NameAConditionThatIsAlwaysTrue) {
  EXPECT_EQ(of("c != 1 || c != 2 || d"),
            "My.ino:2: warning: 'c' differs from 1 or from 2 at any time, so this condition is always true");
  EXPECT_THAT(of("digitalRead(3) != 0 || digitalRead(3) != 1"), HasSubstr("always true"));
}

TEST(ConditionWarnings, KeepSilentAboutOtherConditions) {
  for (const char* condition :
       {"s[0] == 0 && s[1] == 1 && s[2] == 0", "a && x == 1 || b && x == 0", "x == 1 || x == 2 || x == 3",
        "x != 1 && x != 2 && x != 3", "a && x == y && x == z",
        "Serial.read() == 1 && a && Serial.read() == 0", "a && s[i++] == 1 && s[i++] == 0",
        "a && x <= 1 && x >= 0", "f(x == 1, a && b, x == 0)", "a && (x == 1 ? b : x == 0)",
        "a && (x = next()) == 1 && x == 0", "x == 1 && x == 0", "a && x == 1 && !(x == 0)",
        "a && x == 1.5 && x == 2.5", "!a || x == 1 || b && x == 1"})
    EXPECT_EQ(of(condition), "") << condition;
  EXPECT_EQ(in("void loop() { if (a && x == 1) f(); if (b && x == 0) f(); }"), "");
}

TEST(ConditionWarnings, ReadDeepNestingAndTornText) {
  EXPECT_EQ(in(std::string(50'000, '(') + "a == 1" + std::string(50'000, ')')), "");
  for (const char* code : {"", "(", ")", "&&", "||", "(a ==", "a == 1 &&", "== 1 && == 1 && == 1", "))))"})
    in(code);
}

}  // namespace condition_warnings_test
}  // namespace robosim::build
