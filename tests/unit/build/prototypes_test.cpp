#include "sim/build/prototypes.h"

#include <gmock/gmock.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace prototypes_test {

using testing::HasSubstr;
using testing::Not;

class PrototypesTest : public SketchTest {
 protected:
  /// Adds prototypes to the source that Robosim generates from a sketch. The sketch has one file, X.ino,
  /// which contains `code`.
  std::string with_prototypes(const std::string& code) const {
    const std::string joined = "#include <Arduino.h>\n#line 1 \"X.ino\"\n" + code;
    return add_prototypes(joined, "# 1 \"Arduino.h\" 1\nvoid pinMode(int) {}\n# 1 \"X.ino\" 2\n" + code,
                          {"X.ino"}, folder_);
  }
};

TEST_F(PrototypesTest, StandBeforeTheFirstFunction) {
  EXPECT_EQ(with_prototypes("enum E { a };\nint x;\nvoid setup() {}\nint f(E e) { return e; }\n"),
            "#include <Arduino.h>\n#line 1 \"X.ino\"\nenum E { a };\nint x;\n"
            "#line 3 \"X.ino\"\nvoid setup();\n#line 4 \"X.ino\"\nint f(E e);\n#line 3 \"X.ino\"\n"
            "void setup() {}\nint f(E e) { return e; }\n");
}

TEST_F(PrototypesTest, AreRightBehindAUsingDirective) {
  EXPECT_THAT(with_prototypes("namespace motors {}\nusing namespace motors;\nvoid setup() {}\n"),
              HasSubstr("using namespace motors;\n#line 3 \"X.ino\"\nvoid setup();\n#line 3"));
}

TEST_F(PrototypesTest, StandBeforeAVariableThatNamesAFunction) {
  EXPECT_THAT(with_prototypes("int x;\nTimer t(&tick);\nvoid tick() {}\n"),
              HasSubstr("int x;\n#line 3 \"X.ino\"\nvoid tick();\n#line 2 \"X.ino\"\nTimer t(&tick);\n"));
}

TEST_F(PrototypesTest, TakeTheDefaultArgumentsFromTheDefinition) {
  const std::string result =
      with_prototypes("void f(int a = g(1, 2), /* b */ const char* b = \"x, y) = {\", int c) {\n}\n");
  EXPECT_THAT(result, HasSubstr("\nvoid f(int a = g(1, 2),   const char* b = \"x, y) = {\", int c);\n"));
  EXPECT_THAT(result, HasSubstr("\nvoid f(int a          , /* b */ const char* b              , int c) {\n"));
}

TEST_F(PrototypesTest, KeepStaticTemplateAndExternC) {
  EXPECT_THAT(with_prototypes("static int f() { return 1; }\n"), HasSubstr("\nstatic int f();\n"));
  EXPECT_THAT(with_prototypes("int g() { static int n; return ++n; }\n"), HasSubstr("\nint g();\n"));
  EXPECT_THAT(with_prototypes("extern \"C\" void f(int a) {}\n"),
              HasSubstr("\nextern \"C\" void f(int a);\n"));
  EXPECT_THAT(with_prototypes("template <typename T> T f(T a) { return a; }\n"),
              HasSubstr("\ntemplate <typename T> T f(T a) ;\n"));
  EXPECT_THAT(with_prototypes("template <typename T>\nT f(T a)\n{ return a; }\n"),
              HasSubstr("\ntemplate <typename T> T f(T a) ;\n"));
}

TEST_F(PrototypesTest, OfAFunctionInAnExternCBlockAreExternCToo) {
  const std::string result =
      with_prototypes("void a() {}\nextern \"C\" {\nvoid b() { if (1) {} }\nvoid c() {}\n}\nvoid d() {}\n");
  EXPECT_THAT(result, HasSubstr("\nextern \"C\" void b();\n"));
  EXPECT_THAT(result, HasSubstr("\nextern \"C\" void c();\n"));
  EXPECT_THAT(result, HasSubstr("\nvoid d();\n"));
}

TEST_F(PrototypesTest, TakeDefaultArgumentsAsThePreprocessorGivesThem) {
  const std::string joined = "#line 1 \"X.ino\"\nvoid a() {}\n#define LATE 7\nvoid ab(int ab1 = LATE) {}\n";
  const std::string result =
      add_prototypes(joined, "# 1 \"X.ino\"\nvoid a() {}\n\nvoid ab(int ab1 = 7) {}\n", {"X.ino"}, folder_);
  EXPECT_THAT(result, HasSubstr("\nvoid ab(int ab1 = 7);\n"));
  EXPECT_THAT(result, HasSubstr("\nvoid ab(int ab1       ) {}\n"));
}

TEST_F(PrototypesTest, AreNotMadeForWhatHasOneOrCannotHaveOne) {
  EXPECT_THAT(with_prototypes("void f(int a);\nvoid f(int a) {}\n"), Not(HasSubstr("#line 2")));
  EXPECT_THAT(with_prototypes("struct S { void f() {} };\nvoid S::g() {}\nnamespace n { void h() {} }\n"),
              Not(HasSubstr("();\n")));
  EXPECT_THAT(with_prototypes("void (*f(int a))(int) { return 0; }\n"), Not(HasSubstr("f(int a);")));
}

TEST_F(PrototypesTest, AreMadeForMultilineParameterLists) {
  EXPECT_THAT(with_prototypes("int f(int a,\n      int b)\n{ return a; }\n"),
              HasSubstr("\nint f(int a, int b);\n"));
}

TEST_F(PrototypesTest, LeaveOutWhatThePreprocessorLeavesOut) {
  const std::string joined =
      "#include <Arduino.h>\n#line 1 \"X.ino\"\n#if 0\nvoid never() {}\n#endif\nvoid f() {}\n";
  const std::string result = add_prototypes(joined, "# 4 \"X.ino\"\nvoid f() {}\n", {"X.ino"}, folder_);
  EXPECT_THAT(result, HasSubstr("#endif\n#line 4 \"X.ino\"\nvoid f();\n#line 4 \"X.ino\"\nvoid f() {}\n"));
  EXPECT_THAT(result, Not(HasSubstr("void never();")));
}

}  // namespace prototypes_test
}  // namespace robosim::build
