#include "sim/build/warning_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace warning_filter_test {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class Slips : public SketchTest {
 protected:
  /// Returns the compiler's messages for a sketch whose loop() has this body. The body begins at the sketch's
  /// line 6.
  std::string said_of(const std::string& body) {
    write("My/My.ino",
          "#define LOG(x)\nint x, y, z;\nvoid f() {}\nvoid setup() {}\nvoid loop() {\n" + body + "\n}\n");
    return build_here("My").messages;
  }
};

TEST_F(Slips, AreShownWithTheFunctionThatTheyAreIn) {
  const std::string said = said_of(
      "if (x = 1) f();\nwhile (x = y) f();\nif (400 < x < 600) f();\nif (x);\nif (x > (y + 1)) ;\n"
      "if (x) f(); else;");
  EXPECT_THAT(said, HasSubstr("loop()"));
  for (int line = 6; line <= 11; ++line)
    EXPECT_THAT(said, ContainsRegex("My.ino:" + std::to_string(line) + ":[0-9]+: warning"));
}

TEST_F(Slips, RightCodeIsNotWarnedOf) {
  EXPECT_EQ(said_of("x = x & B11111000 | B001;\nif (x && y || z) f();\nx = y << 1 + 2;\nif (x) LOG(1);\n"
                    "if (x == 1 & y == 2) f();\nif (x) if (y) f(); else LOG(y);\nif ((x = y)) f();"),
            "");
}

TEST_F(Slips, ConditionsThatAreAlwaysTrueOrFalseAreShown) {
  const std::string said = said_of(
      "byte b = x;\nif (b < 0) f();\nif (b > 255) f();\nif (x < 3 && x > 5) f();\nif (x != 3 || x != 5) "
      "f();\n"
      "if (!x == 2) f();\nif ((x & 4) == 1) f();\nif (x > 3) f(); else if (x > 3) f();\nif (b != -1) f();");
  for (int line = 7; line <= 14; ++line)
    EXPECT_THAT(said, ContainsRegex("My.ino:" + std::to_string(line) + ":[0-9]+: warning"));
}

TEST_F(Slips, StatementsWithoutEffectAndOutsideOfTheirIfAreShown) {
  const std::string said = said_of("x == 3;\nx + 1;\nif (y)\n  x = 1;\n  y = 2;\nf;");
  for (int line : {6, 7, 11})
    EXPECT_THAT(said, ContainsRegex("My.ino:" + std::to_string(line) + ":[0-9]+: warning"));
  EXPECT_THAT(said, HasSubstr("My.ino:10: warning: this line does not belong to the 'if' of line 8"));
}

TEST_F(Slips, AnIgnoredResultOfAMacroIsShownOnceWithWhatToWrite) {
  const std::string said = said_of("constrain(x, 0, 255);\nabs(y);\nz = abs(y);");
  EXPECT_THAT(said,
              HasSubstr("My.ino:6: warning: constrain() changes nothing here, but returns a result: write x "
                        "= constrain(x, …)\n"));
  EXPECT_THAT(said, HasSubstr("My.ino:7: warning: abs() changes nothing here"));
  EXPECT_THAT(said, Not(HasSubstr("conditional expression")));
  EXPECT_THAT(said, Not(HasSubstr("My.ino:8")));
}

TEST_F(Slips, ConditionsThatAMacroMakesAlwaysTrueAreNotShown) {
  EXPECT_EQ(said_of("byte b = x;\ny = constrain(b, 0, 255);\nz = max(b, 0);\nif (bitRead(b, 1) == 1) f();"),
            "");
}

TEST_F(Slips, ASlipBehindRightCodeKeepsItsPlaceAndWhatElseIsSaidIsKept) {
  const std::string said = said_of("x = y & 4 | 1; if (x = 1) f(); x = 'ab';");
  EXPECT_THAT(said, AllOf(HasSubstr("In function"), HasSubstr("'=' assigns"), Not(HasSubstr("arithmetic"))));
  EXPECT_THAT(said, HasSubstr("multi-character"));
}

TEST_F(Slips, AVariableThatAPathLeavesUnsetIsToldWhereItIsCompiledWithChecks) {
  const auto said = [&](const std::string& body) {
    write("My/My.ino", "int x;\nvoid setup() {}\nvoid loop() {\n" + body + "\n}\n");
    return build({folder_ / "My", *find_board("uno"), "host", {}, Warnings::standard, true}).messages;
  };
  const std::string inverted =
      said("bool inverted; if (Serial.read() == 'i') inverted = true;\nif (inverted) x++;");
  EXPECT_THAT(inverted, AllOf(HasSubstr("My.ino:5:1: warning: 'inverted' may be used uninitialized"),
                              HasSubstr("My.ino:4:6: note: 'inverted' was declared here")));
  EXPECT_EQ(said("int n; const bool any = Serial.available(); if (any) n = Serial.read();\nif (any) x = n;"),
            "");
  EXPECT_EQ(said("int n; if (!Serial.readBytes((char*)&n, 2)) n = 0;\nx = n;"), "");
}

TEST(SlipsOf, NotesInOtherFilesGoWithTheirMessages) {
  const std::string shadow =
      "My.ino: In function 'void f()':\n"
      "My.ino:9:8: warning: declaration of 'byte' shadows a global declaration [-Wshadow]\n"
      "   int byte = 1;\n"
      "        ^\n"
      "In file included from My.ino:1:0:\n"
      "Arduino.h:127:17: note: shadowed declaration is here\n"
      " typedef uint8_t byte;\n"
      "                 ^\n";
  const std::string instance =
      "In file included from My.h:5:0,\n"
      "                 from My.ino:1:\n"
      "Path.h: In instantiation of 'void relax() [with int k = 64]':\n"
      "Path.h:149:12:   required from 'void next() [with int k = 64]'\n"
      "My.ino:169:63:   required from here\n"
      "Path.h:80:9: warning: declaration of 'n' shadows a member of 'this' [-Wshadow]\n";
  EXPECT_EQ(without_style_warnings(shadow + instance), "");
}

TEST(SlipsOf, MessagesOfAvrGccAreReadToo) {
  const std::string both =
      "My.ino: In function 'void loop()':\n"
      "My.ino:3:9: warning: suggest parentheses around '&&' within '||' [-Wparentheses]\n"
      "   if (a && b || c) f();\n         ^\n"
      "My.ino:4:9: warning: suggest braces around empty body in an 'if' statement [-Wempty-body]\n"
      "   if (a);\n         ^";
  EXPECT_EQ(without_style_warnings(both),
            "My.ino: In function 'void loop()':\n"
            "My.ino:4:9: warning: suggest braces around empty body in an 'if' statement [-Wempty-body]\n"
            "   if (a);\n         ^");
}

}  // namespace warning_filter_test
}  // namespace robosim::build
