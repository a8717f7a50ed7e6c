// Tests the findings, and their messages, of a sketch that is built with `--sanitize`.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::sanitize_test {

class SanitizeTest : public HostTest {
 protected:
  SanitizeTest() { sanitize_ = true; }

  /// Runs a sketch with `line_1` on line 1 and `void faulty() { BODY }` on line 2. setup() calls faulty().
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
               "index 5 is outside of the array, an int [5]: valid indices are 0 to 4");
  expect_found("char a[3]; volatile int i = -1;", "a[i] = 1;",
               "index -1 is outside of the array, a char [3]: valid indices are 0 to 2");
  expect_found("volatile unsigned long i = 1234567890;", "volatile byte a[2]; a[i] = 1;",
               "index 1234567890 is outside of the array, an unsigned char [2]: valid indices are 0 to 1");
}

TEST_F(SanitizeTest, AnOverflowOfASignedNumber) {
  const std::string ends = " does not fit an int, which holds -2147483648 to 2147483647 here";
  expect_found("volatile int a = 2147483647, b = 1;", "a = a + b;", "2147483647 + 1" + ends);
  expect_found("volatile int a = -2147483647, b = 2;", "a = a - b;", "-2147483647 - 2" + ends);
  expect_found("volatile int a = 65536;", "a = a * a;", "65536 * 65536" + ends);
  expect_found("volatile int a = -2147483648;", "a = -a;", "-(-2147483648)" + ends);
  expect_found("volatile int a = -2147483648, b = -1;", "a = a / b;", "-2147483648 / -1" + ends);
  expect_found("volatile long long a = 9223372036854775807;", "a++;",
               "9223372036854775807 + 1 does not fit a long long int, which holds -9223372036854775808 to "
               "9223372036854775807 here");
}

TEST_F(SanitizeTest, AShiftThatIsTooFar) {
  expect_found("volatile int by = 32; volatile int one = 1;", "one = one << by;",
               "a shift by 32 bits, but an int has 32 here: 0 to 31 are possible");
  expect_found("volatile int by = -1; volatile int one = 1;", "one = one >> by;",
               "a shift by -1 bits, but an int has 32 here: 0 to 31 are possible");
}

TEST_F(SanitizeTest, ADivisionByZero) {
  expect_found("volatile int zero, n;", "n = 10 / zero;", "division by zero");
  expect_found("volatile int zero, n;", "n = 10 % zero;", "division by zero");
}

TEST_F(SanitizeTest, AnEmptyRangeOfMap) {
  expect_found("volatile int n, least = 3, most = 3;", "n = map(5, least, most, 0, 9);",
               "division by zero in map()");
  expect_nothing("volatile int n, least = 3, most = 4;", "n = map(5, least, most, 0, 9);");
}

TEST_F(SanitizeTest, APointerThatArithmeticSpoils) {
  expect_found("char* volatile p; volatile int by = -1;", "p = p + by;", "arithmetic with a null pointer");
  expect_found("char there; volatile long by = -(1L << 62); char* volatile p = &there;", "p = p + by;",
               "arithmetic moved a pointer beyond the end of memory");
  expect_nothing("char there[3]; volatile int by = 1; char* volatile p = there;", "p = p + by; p = p - by;");
}

TEST_F(SanitizeTest, AnArrayOfVariableLengthWithoutElements) {
  expect_found("volatile int n = -3; char* volatile p;", "char all[n]; p = all;", "an array of -3 elements");
  expect_nothing("volatile int n = 3; char* volatile p;", "char all[n]; p = all;");
}

TEST_F(SanitizeTest, ANullPointerAsAnArgument) {
  const std::string takes =
      "__attribute__((noinline, nonnull(1))) void take(char* at) { asm volatile(\"\" : : "
      "\"r\"(at)); } char there; char* volatile p";
  expect_found(takes + ";", "take(p);", "argument 1 is a null pointer, which is not allowed");
  expect_nothing(takes + " = &there;", "take(p);");
}

TEST_F(SanitizeTest, APlaceThatIsNeverReached) {
  expect_found("volatile int n;", "if (n == 0) __builtin_unreachable();",
               "a place that the program marks as never reached");
  expect_nothing("volatile int n;", "if (n != 0) __builtin_unreachable();");
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
      "read of an int at an address that is not a multiple of 4 (the Uno accepts it, other chips do not)");
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
               "valid indices are 0 to 4");
}

TEST_F(SanitizeTest, AFunctionWithoutItsReturn) {
  expect_found("volatile int n; int turn() { if (n) return 1; }", "n = turn();",
               "the function should return a value, but ends without return", "turn", 1);
  expect_nothing("volatile int n = 1; int turn() { if (n) return 1; }", "n = turn();");
}

TEST_F(SanitizeTest, AnAccessBesideAGlobalVariable) {
  expect_found("char text[10]; char* volatile p = text; volatile int i = 10;", "p[i] = 1;",
               "write of 1 byte, right after the variable text (10 bytes)");
  expect_found("int speeds[5]; int* volatile p = speeds; volatile int i = 6, n;", "n = p[i];",
               "read of 4 bytes, 4 bytes after the variable speeds (20 bytes)");
  expect_found("int speeds[5]; int* volatile p = speeds; volatile int i = -1, n;", "n = p[i];",
               "read of 4 bytes, 4 bytes before the variable speeds (20 bytes)");
}

TEST_F(SanitizeTest, AnAccessBesideALocalVariable) {
  expect_found("volatile int i = 7, n; char* volatile p;",
               "char text[7], other[9]; other[0] = 1; p = text; p[i] = 2; n = other[0];",
               "write of 1 byte, right after the local variable text (7 bytes)");
  expect_found("volatile int i = -2, n; int* volatile p;", "int all[3]; p = all; n = p[i];",
               "read of 4 bytes, 8 bytes before the local variable all (12 bytes)");
}

TEST_F(SanitizeTest, AnAccessToALocalVariableOfABlockThatHasEnded) {
  expect_found("volatile int n = 1; char* volatile p;", "{ char inner[4]; p = inner; p[0] = 1; } n = p[0];",
               "read of 1 byte in the local variable inner, which no longer exists: its block has ended");
}

TEST_F(SanitizeTest, AnAccessBesideALocalArrayOfVariableLength) {
  expect_found("volatile int n = 5; char* volatile p;", "char all[n]; p = all; p[n] = 1;",
               "write of 1 byte outside of a local array");
}

TEST_F(SanitizeTest, AnAccessBesideABlockOfTheHeap) {
  expect_found("volatile int n = 20; char* volatile p;", "p = (char*)malloc(n); p[n] = 1;",
               "write of 1 byte, right after a block from malloc() or new (20 bytes)");
  expect_found("volatile int n = 3; int* volatile p;", "p = new int[n]; p[-1] = 1;",
               "write of 4 bytes, 4 bytes before a block from malloc() or new (12 bytes)");
}

TEST_F(SanitizeTest, AnAccessToABlockThatWasGivenBack) {
  expect_found("struct Motor { int speed; }; Motor* volatile p; volatile int n;",
               "p = new Motor; p->speed = 1; delete p; n = p->speed;",
               "read of 4 bytes in a block of 4 bytes that was freed by free() or delete");
  expect_found("char* volatile p; volatile int n;",
               "p = (char*)malloc(9); free(p); char* q = (char*)malloc(9); q[0] = 1; n = p[0];",
               "read of 1 byte in a block of 9 bytes that was freed by free() or delete");
  expect_found("char* volatile p;", "p = (char*)malloc(9); free(p); free(p);",
               "free() or delete of memory that was already freed");
}

TEST_F(SanitizeTest, AFunctionOfTheCLibraryThatIsGivenTooLittleRoom) {
  expect_found("char text[4]; const char* volatile from = \"hello\";", "strcpy(text, from);",
               "write of 6 bytes, across the end of the variable text (4 bytes)");
  expect_found("char text[4]; volatile int n = 5;", "memset(text, 0, n);",
               "write of 5 bytes, across the end of the variable text (4 bytes)");
  expect_found("char text[4]; volatile int n = 123456;", "sprintf(text, \"%d\", n);",
               "write of 1 byte, right after the variable text (4 bytes)");
  expect_found("char text[4]; volatile int n = 123456;", "itoa(n, text, 10);",
               "write of 1 byte, right after the variable text (4 bytes)");
  expect_found("char text[3];", "memset(text, 'x', 3); Serial.print(text);",
               "read of 4 bytes, across the end of the variable text (3 bytes)");
}

TEST_F(SanitizeTest, AWildPointer) {
  expect_found("volatile int n; char there; volatile long far = 1L << 30;",
               "char* volatile p = &there; p[far] = 1;",
               "write of 1 byte at a place where the sketch has no variable (a wild pointer or index?)");
}

TEST_F(SanitizeTest, APowerCycleBeginsAfresh) {
  start(
      "char text[10]; char* volatile p = text; volatile int i = 10; void setup() { char local[9]; p[0] = "
      "local[0]; p[i] = 1; } void loop() {}");
  for (int cycle = 0; cycle < 3; ++cycle) {
    run(kMillisecond);
    ASSERT_TRUE(host_->crash());
    EXPECT_THAT(host_->crash()->reason, testing::HasSubstr("right after the variable text"));
    host_->power_on(now_);
  }
}

TEST_F(SanitizeTest, TwoFirmwaresSideBySideHaveEachTheirOwn) {
  const auto good = build(
      "char text[10]; void setup() { Serial.begin(9600); } void loop() { for (char& c : text) c++; "
      "Serial.print(text[9] > 0); }");
  HostExecutor first(*find_board("uno"), good);
  first.power_on(0);
  {
    HostExecutor second(*find_board("uno"), good);
    second.power_on(0);
    second.run_until(kMillisecond);
    EXPECT_FALSE(second.crash());
  }
  first.run_until(kMillisecond);
  EXPECT_FALSE(first.crash());
}

TEST_F(SanitizeTest, WhatIsAllowedIsNotFound) {
  expect_nothing("volatile unsigned u = 4294967295; volatile int m = -1; volatile byte b = 255;",
                 "u++; u -= 1; m = m << 3; m = 1 << 31; b++; volatile char c = 200; u = c;");
  expect_nothing(
      "String all; char text[20]; volatile int n = 7;",
      "for (int i = 0; i < 500; i++) { all += i; if (all.length() > 50) all = String(i) + \"x\"; } "
      "char* p = (char*)malloc(5); strcpy(p, \"1234\"); p = (char*)realloc(p, 30); strcat(p, \"567\"); "
      "free(p); "
      "for (int i = 0; i < 50000; i++) delete[] new char[n]; char v[n]; memset(v, 1, n); "
      "sprintf(text, \"%d %s\", n, \"abc\"); Serial.begin(9600); Serial.println(text); Serial.println(all);");
}

}  // namespace robosim::exec::sanitize_test
