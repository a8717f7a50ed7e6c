// What the checks of a sketch built with --sanitize find, and how they say it.
#include "tests/unit/executors/fixture.h"

namespace robosim::executors {
namespace {

class SanitizeTest : public HostTest {
 protected:
  SanitizeTest() { sanitize_ = true; }

  /// Line 1 of the sketch is `line_1`, line 2 is `void faulty() { BODY }`, which setup() calls once.
  void start_faulty(const std::string& line_1, const std::string& body) {
    start(line_1 + "\nvoid faulty() { " + body +
          " }\nvoid setup() {\n  delay(5);\n  faulty();\n}\nvoid loop() {}\n");
    run(kSecond);
  }

  void expect_found(const std::string& line_1, const std::string& body, const std::string& reason,
                    const std::string& function = "faulty", int line = 2) {
    start_faulty(line_1, body);
    ASSERT_TRUE(host_->crash()) << body << " was not found";
    EXPECT_EQ(host_->crash()->reason, reason);
    EXPECT_EQ(host_->crash()->where.function, function) << body;
    EXPECT_EQ(host_->crash()->where.file, "Test.ino") << body;
    EXPECT_EQ(host_->crash()->where.line, line) << body;
  }

  void expect_nothing(const std::string& line_1, const std::string& body) {
    start_faulty(line_1, body);
    EXPECT_FALSE(host_->crash()) << body << ": " << host_->crash()->reason;
  }
};

TEST_F(SanitizeTest, AnIndexOutsideOfAnArray) {
  expect_found("int a[5]; volatile int i = 5;", "a[i] = 1;",
               "index 5 is outside of the array, an int [5]: its first is 0 and its last 4");
  expect_found("char a[3]; volatile int i = -1;", "a[i] = 1;",
               "index -1 is outside of the array, a char [3]: its first is 0 and its last 2");
  expect_found(
      "volatile unsigned long i = 1234567890123;", "volatile byte a[2]; a[i] = 1;",
      "index 1234567890123 is outside of the array, an unsigned char [2]: its first is 0 and its last 1");
}

TEST_F(SanitizeTest, AnOverflowOfASignedNumber) {
  const std::string ends = " does not fit an int, which holds -2147483648 to 2147483647 here";
  expect_found("volatile int a = 2147483647, b = 1;", "a = a + b;", "2147483647 + 1" + ends);
  expect_found("volatile int a = -2147483647, b = 2;", "a = a - b;", "-2147483647 - 2" + ends);
  expect_found("volatile int a = 65536;", "a = a * a;", "65536 * 65536" + ends);
  expect_found("volatile int a = -2147483648;", "a = -a;", "-(-2147483648)" + ends);
  expect_found("volatile int a = -2147483648, b = -1;", "a = a / b;", "-2147483648 / -1" + ends);
  expect_found("volatile long a = 9223372036854775807;", "a++;",
               "9223372036854775807 + 1 does not fit a long int, which holds -9223372036854775808 to "
               "9223372036854775807 here");
}

TEST_F(SanitizeTest, AShiftThatIsTooFar) {
  expect_found("volatile int by = 32; volatile int one = 1;", "one = one << by;",
               "a shift by 32 bits, and an int has 32 here: 0 to 31 are possible");
  expect_found("volatile int by = -1; volatile int one = 1;", "one = one >> by;",
               "a shift by -1 bits, and an int has 32 here: 0 to 31 are possible");
}

TEST_F(SanitizeTest, ADivisionByZero) {
  expect_found("volatile int zero, n;", "n = 10 / zero;", "division by zero");
  expect_found("volatile int zero, n;", "n = 10 % zero;", "division by zero");
}

TEST_F(SanitizeTest, ANullPointer) {
  expect_found("int* volatile p;", "*p = 1;", "write of an int through a null pointer");
  expect_found("struct Motor { int speed; void go() { speed = 1; } }; Motor* volatile p;", "p->speed = 1;",
               "access to a member of a Motor through a null pointer");
  expect_found("struct Motor { int speed; void go() { speed = 1; } }; Motor* volatile p;", "p->go();",
               "call of a member function of a Motor through a null pointer");
}

TEST_F(SanitizeTest, AMisalignedAccess) {
  expect_found(
      "byte a[8]; volatile int n, i = 1;", "n = *(int*)(a + i);",
      "read of an int at an address that is not a multiple of 4 (the Uno does not mind, other chips do)");
}

TEST_F(SanitizeTest, AFloatThatDoesNotFit) {
  expect_found("volatile float f = 3e10; volatile int n;", "n = f;",
               "float 30000000000 does not fit an int, which holds -2147483648 to 2147483647 here");
  expect_found("volatile double d = -1; volatile byte n;", "n = d;",
               "double -1 does not fit an unsigned char, which holds 0 to 255 here");
}

TEST_F(SanitizeTest, ABoolOrEnumThatIsNone) {
  expect_found("volatile byte b = 7; volatile int n;", "n = *(bool*)&b;",
               "a bool holds 7: only 0 and 1 are possible");
  expect_found("enum Mode { kWait, kDrive, kTurn }; alignas(4) volatile byte b[4] = {77}; volatile int n;",
               "n = *(Mode*)b;", "a Mode holds 77: none of its values");
}

TEST_F(SanitizeTest, ALocalVariableThatWasNeverSet) {
  expect_found("int a[5]; void (*volatile nothing)(int*) = [](int*) {};", "int i; nothing(&i); a[i] = 1;",
               "index -16843010 (a local variable that was never set?) is outside of the array, an int [5]: "
               "its first is 0 and its last 4");
}

TEST_F(SanitizeTest, AFunctionWithoutItsReturn) {
  expect_found("volatile int n; int turn() { if (n) return 1; }", "n = turn();",
               "the function should give a value, and ends without return", "turn", 1);
}

TEST_F(SanitizeTest, WhatIsAllowedIsNotFound) {
  expect_nothing("volatile unsigned u = 4294967295; volatile int m = -1; volatile byte b = 255;",
                 "u++; u -= 1; m = m << 3; m = 1 << 31; b++; volatile char c = 200; u = c;");
}

}  // namespace
}  // namespace robosim::executors
