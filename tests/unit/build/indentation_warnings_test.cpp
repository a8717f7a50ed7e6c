#include "sim/build/indentation_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace robosim::build {
namespace indentation_warnings_test {

using ::testing::HasSubstr;

std::string in(const std::string& code) { return indentation_warnings("#line 1 \"My.ino\"\n" + code + "\n"); }

TEST(IndentationWarnings, NameALineThatOnlyLooksLikeAPartOfTheIf) {
  EXPECT_EQ(
      in("  if (button == 1)\n    left = 0;\n    right = 0;\n"),
      "My.ino:3: warning: this line does not belong to the 'if' of line 1, which ends before it: put both "
      "lines into { }, or indent this one less");
  for (const char* code : {"for (int i = 0; i < 3; i++)\n\tread(i);\n\tshow(i);",
                           "while (f(1, g(2)))\n  a();\n  b();", "{\nelse\n  a = 1;\n  b = 1;\n}",
                           "else if (x)\n  a = 1;\n  b = 1;", "if (x)\n  a(1,\n    2);\n  b();"})
    EXPECT_THAT(in(code), HasSubstr("does not belong to the '")) << code;
}

TEST(IndentationWarnings, KeepSilentAboutOtherLines) {
  for (const char* code :
       {"if (x)\n  a();\nb();", "if (x) {\n  a();\n  b();\n}", "if (x)\n  a();\nelse\n  b();",
        "if (x) a();\nb();", "if (x) a(); b();", "if (x)\na();\nb();", "  if (x)\na();\nb();",
        "if (x)\n\ta();\n        b();", "if (x)\n  if (y)\n    a();\n  b();", "while (x)\n  ;\n  b();",
        "if (x)\n#ifdef A\n  a();\n#else\n  b();\n#endif\n  c();", "if (x)\n  return;\n  }",
        "switch (x) {\ncase 1:\n  if (y)\n    a();\n    case 2: b();\n}", "do\n  a();\n  while (x);",
        "#define A if (x)\n  a();\n  b();", "// if (x)\n  a();\n  b();"})
    EXPECT_EQ(in(code), "") << code;
}

TEST(IndentationWarnings, ReadTornText) {
  for (const char* code : {"", "if", "if (", "if (x)", "if (x)\n  a", "else", "else if", "for (;;)\n a;\n b"})
    in(code);
}

}  // namespace indentation_warnings_test
}  // namespace robosim::build
