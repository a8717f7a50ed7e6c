#include "sim/build/arithmetic_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace robosim::build {
namespace arithmetic_warnings_test {

using ::testing::HasSubstr;

std::string in(const std::string& code) { return arithmetic_warnings("#line 1 \"My.ino\"\n" + code + "\n"); }

TEST(ArithmeticWarnings, NameAQuotientOfIntegersThatIsZero) {
  EXPECT_EQ(in("float kp = 0;\nvoid setup() { kp = 1 / 4; }"),
            "My.ino:2: warning: 1 / 4 is 0, because a quotient of integers has no fraction: for 0.25, write "
            "1.0 / 4");
  EXPECT_EQ(in("const int GAIN = 3, SCALE = 10;\nfloat turn(int e) { return e + GAIN / SCALE * e; }"),
            "My.ino:2: warning: GAIN / SCALE is 0, because a quotient of integers has no fraction: for 0.3, "
            "write (float)GAIN / SCALE");
  for (const char* code : {"float kp = (3/10);", "float f() { return 1/3 * x; }", "int a = b - 1/2;",
                           "float k[] = {1/4, 2};", "f(-2/5);", "constexpr byte A = 9; float k = A / 10;"})
    EXPECT_THAT(in(code), HasSubstr(" is 0, because a quotient of integers has no fraction")) << code;
}

TEST(ArithmeticWarnings, KeepSilentAboutOtherQuotients) {
  for (const char* code : {"int t = error * 1 / 4;",
                           "float kp = 1.0 / 4;",
                           "float kp = 1 / 4.0;",
                           "float kp = 1 / 4.;",
                           "float kp = 1 / 4f;",
                           "float kp = (float)1 / 4;",
                           "int a = 4 / 1;",
                           "int a = 0 / 4;",
                           "int a = 4 / 4;",
                           "const float A = 1; float k = A / 4;",
                           "int a = 1; void f() { g(a); float k = a / 4; }",
                           "int k = 1 / table[2];",
                           "const int N = 1; int k = N / n();",
                           "int k = s.A / 4; const int A = 1;",
                           "struct S { int A; }; const int A = 1; S* p; int k = p->A / 4;",
                           "int k = a % 3 / 4;",
                           "int k = x / 1 / 4;",
                           "#define KP 1 / 4",
                           "// float kp = 1 / 4;",
                           "int k = 1 / 4'0;"})
    EXPECT_EQ(in(code), "") << code;
}

TEST(ArithmeticWarnings, NameAnIntegerVariableThatLosesAFraction) {
  EXPECT_EQ(in("int ki = 4;\nint kp = 0.35;"),
            "My.ino:2: warning: 'kp' has an integer type, so it becomes 0, not 0.35: declare 'kp' as float");
  EXPECT_THAT(in("const byte kd = .5;"), HasSubstr("'kd' has an integer type, so it becomes 0, not .5"));
  EXPECT_THAT(in("long kp;\nvoid setup() { kp = -1.75f; }"), HasSubstr("so it becomes -1, not -1.75f"));
  EXPECT_THAT(in("void drive(int left, int gain = 0.5) {}"), HasSubstr("'gain' has an integer type"));
}

TEST(ArithmeticWarnings, KeepSilentAboutVariablesThatLoseLittleOrAreFloats) {
  for (const char* code :
       {"int speed = 127.5;", "int speed = 2.0;", "float kp = 0.35;", "double kp = 0.35;",
        "int kp = 0.35 * 100;", "int speed = 200; void f() { speed *= 0.5; }", "auto kp = 0.35;",
        "struct A { float k; }; int k; void f(A& a) { a.k = 0.5; }", "bool turns = a == 0.5;",
        "int zero = 0.0;", "void f(float kp) { kp = 0.5; } int kp;"})
    EXPECT_EQ(in(code), "") << code;
}

TEST(ArithmeticWarnings, NameADelayThatLosesAFraction) {
  EXPECT_EQ(in("void loop() {\n  delay(0.5);\n}"),
            "My.ino:2: warning: delay(0.5) waits 0 ms: its number has no fraction");
  EXPECT_THAT(in("void loop() { delayMicroseconds(1.5); }"), HasSubstr("delayMicroseconds(1.5) waits 1 µs"));
  for (const char* code :
       {"void loop() { delay(500); }", "void loop() { delay(0.5 * 1000); }", "void loop() { delay(62.5); }"})
    EXPECT_EQ(in(code), "") << code;
}

TEST(ArithmeticWarnings, RepeatNoWarningAndSurviveTornText) {
  const std::string once = in("float a = 1 / 4;");
  EXPECT_EQ(in("float a = 1 / 4; float b = 1 / 4;"), once);
  for (const char* code :
       {"", "/", "1 /", "/ 4", "=", "kp =", "kp = -", "kp = .", "delay(", "delay(0.5", "1 / 4"})
    in(code);
}

}  // namespace arithmetic_warnings_test
}  // namespace robosim::build
