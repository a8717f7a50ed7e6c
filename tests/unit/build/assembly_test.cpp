#include "sim/build/assembly.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace robosim::build {
namespace assembly_test {

using testing::HasSubstr;
using testing::Not;

std::string changed(std::string_view assembly, QuotientByZero quotient = QuotientByZero::all_ones) {
  return changed_for_host(assembly, quotient);
}

TEST(EndlessLoops, AJumpToItselfBecomesACall) {
  EXPECT_EQ(changed("loop:\n.L2:\n\tjmp\t.L2\n\tret\n"),
            "loop:\n.L2:\n\tcall\trobosim_endless_loop\n\tret\n");
  EXPECT_EQ(changed(".L2:\n\tb\t.L2\n"), ".L2:\n\tbl\trobosim_endless_loop\n");
}

TEST(EndlessLoops, LabelsDirectivesAndCommentsDoNotCountAsWork) {
  EXPECT_EQ(changed(".L2:\n\t.loc 1 3 4\n.LVL1:\n\n# 3 \"x.ino\" 1\n\tjmp\t.L2\n"),
            ".L2:\n\t.loc 1 3 4\n.LVL1:\n\n# 3 \"x.ino\" 1\n\tcall\trobosim_endless_loop\n");
  EXPECT_EQ(changed(".L2:\n.L3:\n\tjmp\t.L2\n"), ".L2:\n.L3:\n\tcall\trobosim_endless_loop\n");
}

TEST(EndlessLoops, OtherJumpsStay) {
  for (const char* code : {".L2:\n\tnop\n\tjmp\t.L2\n", ".L2:\n\tjmp\t.L3\n", ".L2:\n\tjmp\t*%rax\n",
                           ".L2:\n\tjne\t.L2\n", "\tjmp\t.L2\n.L2:\n", ".L2:\n\tret\n\tb\t.L2\n"})
    EXPECT_EQ(changed(code), code);
}

TEST(PlacesOfAsm, AreReadByEveryAssembler) {
  EXPECT_EQ(changed("#APP\n// 2 \"Boot.ino\" 1\n\twdr\n// 0 \"\" 2\n"),
            "#APP\n# 2 \"Boot.ino\" 1\n\twdr\n# 0 \"\" 2\n");
  EXPECT_EQ(changed("@ 2 \"my sketch.ino\" 1\n\twdr\n"), "# 2 \"my sketch.ino\" 1\n\twdr\n");
}

TEST(PlacesOfAsm, OtherLinesStay) {
  for (const char* code : {"# 2 \"Boot.ino\" 1\n", "// kill: x0\n", "@ args = 0\n", "\tmov\tx0, 1\n\n",
                           "// 2 apples\n", "@ sp needed\n", "//\n@\n"})
    EXPECT_EQ(changed(code), code);
}

// tests/unit/exec/division_test.cpp tests the results of divisions.
TEST(Divisions, LookAtTheDivisorFirstAndKeepTheInstruction) {
  EXPECT_EQ(changed("\tdivl\t-8(%rbp)\n"),
            "\tcmpl\t$0, -8(%rbp)\n"
            "\tjne\t.Lrobosim_divides0\n"
            "\tmovl\t%eax, %edx\n"
            "\tmovl\t$-1, %eax\n"
            "\tjmp\t.Lrobosim_divided0\n"
            ".Lrobosim_divides0:\n"
            "\tdivl\t-8(%rbp)\n"
            ".Lrobosim_divided0:\n");
  EXPECT_EQ(changed("\tsdiv\tx0, x1, x20\n"),
            "\tcbnz\tx20, .Lrobosim_divides0\n"
            "\tasr\tx0, x1, #63\n"
            "\tmvn\tx0, x0, lsl #1\n"
            "\tb\t.Lrobosim_divided0\n"
            ".Lrobosim_divides0:\n"
            "\tsdiv\tx0, x1, x20\n"
            ".Lrobosim_divided0:\n");
  EXPECT_THAT(changed("\tudiv\tw0, w1, w2\n", QuotientByZero::zero), HasSubstr("\tmov\tw0, 0\n"));
}

TEST(Divisions, HaveLabelsOfTheirOwn) {
  const std::string text = changed("\tidivb\t%cl\n\tidivw\t%cx\n\tidivq\t(%rsp,%rax)\n\tdivq\t%rcx\n");
  std::set<std::string> labels;
  const std::regex label(R"((^|\n)(\.L\w+):)");
  for (std::sregex_iterator at(text.begin(), text.end(), label), end; at != end; ++at)
    EXPECT_TRUE(labels.insert((*at)[2]).second) << (*at)[2];
  EXPECT_EQ(labels.size(), 3 * 3u + 2);
}

// A macro must not have the name of an instruction, because binutils 2.44, unlike 2.40, also expands this
// name within the macro.
TEST(Divisions, NeedNoMacroOfTheAssembler) {
  EXPECT_THAT(changed("\tidivl\t%ecx\n\tsdiv\tw0, w0, w1\n"), Not(HasSubstr(".macro")));
}

TEST(Divisions, OtherInstructionsStay) {
  for (const char* code : {"\tdivsd\t%xmm1, %xmm0\n", "\tfdiv\td0, d0, d1\n", "\tsdiv\tr0, r1, r2\n",
                           "\tcall\tdivl\n", "divl:\n", "\tvdivss\t%xmm1, %xmm0, %xmm0\n"})
    EXPECT_EQ(changed(code), code);
}

}  // namespace assembly_test
}  // namespace robosim::build
