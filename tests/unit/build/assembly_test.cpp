#include "sim/build/assembly.h"

#include <gtest/gtest.h>

namespace robosim::build {
namespace {

TEST(EndlessLoops, AJumpToItselfBecomesACall) {
  EXPECT_EQ(call_in_endless_loops("loop:\n.L2:\n\tjmp\t.L2\n\tret\n"),
            "loop:\n.L2:\n\tcall\trobosim_endless_loop\n\tret\n");
  EXPECT_EQ(call_in_endless_loops(".L2:\n\tb\t.L2\n"), ".L2:\n\tbl\trobosim_endless_loop\n");
}

TEST(EndlessLoops, LabelsDirectivesAndCommentsDoNotCountAsWork) {
  EXPECT_EQ(call_in_endless_loops(".L2:\n\t.loc 1 3 4\n.LVL1:\n\n# 3 \"x.ino\" 1\n\tjmp\t.L2\n"),
            ".L2:\n\t.loc 1 3 4\n.LVL1:\n\n# 3 \"x.ino\" 1\n\tcall\trobosim_endless_loop\n");
  EXPECT_EQ(call_in_endless_loops(".L2:\n.L3:\n\tjmp\t.L2\n"), ".L2:\n.L3:\n\tcall\trobosim_endless_loop\n");
}

TEST(EndlessLoops, OtherJumpsStay) {
  for (const char* code : {".L2:\n\tnop\n\tjmp\t.L2\n", ".L2:\n\tjmp\t.L3\n", ".L2:\n\tjmp\t*%rax\n",
                           ".L2:\n\tjne\t.L2\n", "\tjmp\t.L2\n.L2:\n", ".L2:\n\tret\n\tb\t.L2\n"})
    EXPECT_EQ(call_in_endless_loops(code), code);
}

TEST(PlacesOfAsm, AreReadByEveryAssembler) {
  EXPECT_EQ(with_places_of_asm("#APP\n// 2 \"Boot.ino\" 1\n\twdr\n// 0 \"\" 2\n"),
            "#APP\n# 2 \"Boot.ino\" 1\n\twdr\n# 0 \"\" 2\n");
  EXPECT_EQ(with_places_of_asm("@ 2 \"my sketch.ino\" 1\n\twdr\n"), "# 2 \"my sketch.ino\" 1\n\twdr\n");
}

TEST(PlacesOfAsm, OtherLinesStay) {
  for (const char* code : {"# 2 \"Boot.ino\" 1\n", "// kill: x0\n", "@ args = 0\n", "\tmov\tx0, 1\n\n",
                           "// 2 apples\n", "@ sp needed\n", "//\n@\n"})
    EXPECT_EQ(with_places_of_asm(code), code);
}

}  // namespace
}  // namespace robosim::build
