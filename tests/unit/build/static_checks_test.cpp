#include "sim/build/static_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace static_checks_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class StaticChecksTest : public SketchTest {
 protected:
  /// Returns the messages of a build for target host.
  std::string on(const char* board, const std::string& code, Warnings warnings = Warnings::standard) const {
    write("My/My.ino", code + "\nvoid loop() {}\n");
    return build({folder_ / "My", *find_board(board), "host", {}, warnings}).messages;
  }
  std::string in_setup(const std::string& code) const { return on("uno", "void setup() {\n" + code + "\n}"); }
};

TEST_F(StaticChecksTest, AHostBuildNamesWhatOnlyA16BitIntOverflows) {
  EXPECT_THAT(in_setup("delay(4 * 10000);"),
              AllOf(StartsWith("My.ino:2:"), HasSubstr("integer overflow in expression"),
                    HasSubstr(" on the uno, whose int has 16 bits [-Woverflow]\n delay(4 * 10000);\n")));
  EXPECT_THAT(in_setup("unsigned long hour = 60 * 60 * 1000; delay(hour);"),
              AllOf(StartsWith("My.ino:2:"), HasSubstr("whose int has 16 bits")));
  EXPECT_THAT(in_setup("long mask = 1 << 20; delay(mask);"),
              HasSubstr("left shift count >= width of type on the uno"));
  EXPECT_THAT(in_setup("int limit = 100000; delay(limit);"),
              AllOf(HasSubstr("overflow in "), HasSubstr("on the uno, whose int has 16 bits")));
  EXPECT_THAT(on("mega", "void setup() { delay(4 * 10000); }"),
              HasSubstr("on the mega, whose int has 16 bits"));
}

TEST_F(StaticChecksTest, WhatFitsIsNotNamed) {
  EXPECT_EQ(in_setup("delay(4 * 10000L); delay(40000); delay(4UL * 10000);"), "");
  EXPECT_EQ(in_setup("long mask = 1L << 20; delay(mask); int limit = 10000; delay(limit);"), "");
  EXPECT_EQ(in_setup("unsigned int sum = 30000U + 30000U; delay(sum);"), "");
  EXPECT_EQ(on("bluepill", "void setup() { delay(4 * 10000); }"), "") << "a Blue Pill's int has 32 bits";
  EXPECT_EQ(on("uno", "void setup() { delay(4 * 10000); }", Warnings::none), "");
}

TEST_F(StaticChecksTest, WhatTheHostsCompilerNamesIsNotNamedTwice) {
  const std::string messages = in_setup("byte b = 300; delay(b);");
  EXPECT_THAT(messages, AllOf(HasSubstr("My.ino:2:"), Not(HasSubstr("on the uno"))));
}

TEST_F(StaticChecksTest, ErrorsAndOtherWarningsOfTheAvrCompilerDoNotCount) {
  EXPECT_EQ(in_setup("#ifdef ROBOSIM\n#else\n#error \"for Robosim only\"\n#endif\nint x; x = x;"), "");
  EXPECT_THAT(in_setup("#ifndef ROBOSIM\nnot C++ at all;\n#endif\ndelay(4 * 10000);"),
              AllOf(HasSubstr("My.ino:5:"), Not(HasSubstr("error"))));
}

TEST_F(StaticChecksTest, AllSourcesOfASketchAreCheckedButNoLibraryOrCore) {
  write("My/wait.h", "const long kWait = 60 * 1000;\n");
  write("My/wait.cpp", "#include <Arduino.h>\nvoid rest() { delay(5 * 10000); }\n");
  write("libraries/Slow/Slow.h", "const long kSlow = 70 * 1000;\n");
  write("My/My.ino",
        "#include <Slow.h>\n#include \"wait.h\"\nvoid rest();\n"
        "void setup() { rest(); delay(kWait + kSlow); }\nvoid loop() {}\n");
  const std::string messages = build_here("My", {folder_ / "libraries"}).messages;
  EXPECT_THAT(messages, AllOf(HasSubstr("wait.h:1:"), HasSubstr("wait.cpp:2:"), Not(HasSubstr("Slow.h"))));
}

TEST_F(StaticChecksTest, TheWarningComesFromTheCacheAgain) {
  write("My/wait.cpp", "#include <Arduino.h>\nvoid rest() { delay(5 * 10000); }\n");
  const std::string code = "void rest();\nvoid setup() { rest(); }";
  const std::string messages = on("uno", code);
  EXPECT_THAT(messages, StartsWith("wait.cpp:2:"));
  const Image again = build_here("My");
  EXPECT_TRUE(again.from_cache);
  EXPECT_EQ(again.messages, messages);
  EXPECT_EQ(on("uno", code + "\n// changed"), messages) << "the object of wait.cpp is unchanged";
}

TEST_F(StaticChecksTest, WithoutTheAvrCompilerAHostBuildIsAsBefore) {
  const std::filesystem::path tools = folder_ / "tools";
  std::filesystem::create_directories(tools);
  for (const auto& tool : std::filesystem::directory_iterator("/usr/bin"))
    if (!tool.path().filename().string().starts_with("avr-"))
      std::filesystem::create_symlink(tool.path(), tools / tool.path().filename());
  ::setenv("PATH", tools.c_str(), 1);
  EXPECT_EQ(in_setup("delay(4 * 10000);"), "");
}

TEST_F(StaticChecksTest, TheCompilerSeesOnlyTheFilesOfAnUntrustedSketch) {
  write("club/number.h", "4\n");
  write("club/My/My.ino",
        "#ifndef ROBOSIM\nlong product = (\n#include \"../number.h\"\n) * 10000;\n#endif\n" + kEmptySketch);
  Request request{folder_ / "club/My", *find_board("uno")};
  EXPECT_THAT(build(request).messages, StartsWith("My.ino:4:"));
  request.untrusted = true;
  EXPECT_EQ(build(request).messages, "");
  write("club/My/My.ino", "void setup() { delay(4 * 10000); }\nvoid loop() {}\n");
  EXPECT_THAT(build(request).messages, StartsWith("My.ino:1:"));
}

class UnsetVariablesTest : public StaticChecksTest {
 protected:
  /// Returns the messages of a build with --sanitize for a target.
  std::string sanitized(const std::string& code, const char* target = "host") const {
    write("My/My.ino",
          code + "\nvoid setup() { Serial.begin(9600); }\nvoid loop() { Serial.println(f()); }\n");
    Request request{folder_ / "My", *find_board("uno"), target};
    request.sanitize = true;
    return build(request).messages;
  }
};

constexpr const char* kChoice =
    "char choose(byte left, byte ahead) { return left ? 'L' : ahead ? 'A' : 'B'; }\n"
    "char f() {\n  while (true) {\n    byte left;\n    byte ahead;\n"
    "    if (analogRead(A0) > 500) left = 1;\n    delay(5);\n    if (analogRead(A0) > 500) left = 1;\n"
    "    if (analogRead(A2) > 500) ahead = 1;\n    Serial.println(choose(left, ahead));\n  }\n}";

TEST_F(UnsetVariablesTest, ASanitizedBuildNamesVariablesThatTheOptimiserDoesNotName) {
  for (const char* target : {"host", "avr"})
    EXPECT_THAT(sanitized(kChoice, target),
                AllOf(HasSubstr("My.ino:10:"), HasSubstr("'left' may be used before it has a value: give it"),
                      HasSubstr("'ahead' may be used")))
        << target;
  write("My/My.ino", std::string(kChoice) + "\nvoid setup() { Serial.begin(9600); f(); }\nvoid loop() {}\n");
  EXPECT_EQ(build_here("My").messages, "") << "without --sanitize";
}

TEST_F(UnsetVariablesTest, ElementsAndMembersAreNamed) {
  EXPECT_THAT(sanitized("int f() { int v[3]; v[0] = analogRead(A0); v[1] = 4; return v[0] + v[2]; }"),
              AllOf(HasSubstr("My.ino:1:"), HasSubstr("'v[2]'")));
  EXPECT_THAT(
      sanitized(
          "struct P { int x, y; };\nint f() {\n  P p;\n  p.y = 3;\n  Serial.println(p.x);\n  return p.y;\n}"),
      AllOf(HasSubstr("My.ino:5:"), HasSubstr("'p.x'")));
}

TEST_F(UnsetVariablesTest, AVariableIsNamedOnceWhereItIsUsedFirst) {
  const std::string messages =
      sanitized("int f() {\n  int x;\n  Serial.println(x);\n  return x + analogRead(A0);\n}");
  EXPECT_THAT(messages, AllOf(HasSubstr("My.ino:3:"), Not(HasSubstr("My.ino:4:"))));
}

TEST_F(UnsetVariablesTest, VariablesThatAreSetOnEachWayAreNotNamed) {
  for (const char* code : {
           "void read(int* v) { for (int i = 0; i < 5; i++) v[i] = analogRead(i); }\n"
           "int f() { int v[5]; read(v); return v[0] + v[4]; }",
           "void two(int& a, int& b) { a = analogRead(A0); b = 2; }\nint f() { int a, b; two(a, b); return a "
           "- b; }",
           "int f() { int y; bool known = false; if (digitalRead(2)) { y = 4; known = true; } delay(1);\n"
           "  return known ? y : 0; }",
           "int f() { char text[8]; byte n = 0; while (n < 7 && Serial.available()) text[n++] = "
           "Serial.read();\n"
           "  text[n] = 0; return atoi(text); }",
           "bool measure(long* t) { if (!digitalRead(2)) return false; *t = millis(); return true; }\n"
           "long f() { long t; return measure(&t) ? t : 0; }",
           "int f() { int c; do c = Serial.read(); while (c < 0); return c; }",
           "int f() { String s; s += 1; String t = String(s + \"x\"); return t.length(); }",
           "class Pid { float last; public: Pid() { last = 0; } float step(float e) { float d = e - last; "
           "last = e;\n"
           "  return d; } };\nPid pid;\nint f() { return pid.step(analogRead(A0)); }",
       })
    EXPECT_EQ(sanitized(code), "") << code;
}

}  // namespace static_checks_test
}  // namespace robosim::build
