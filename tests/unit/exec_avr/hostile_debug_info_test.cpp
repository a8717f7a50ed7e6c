// Tests debug information that is meant to make Robosim search for ever. The sketch writes this information
// itself, with assembler directives.
#include <gtest/gtest.h>

#include <string>

#include "sim/exec/elf/debug_info.h"
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::hostile_debug_info_test {

constexpr const char* kSketch = "void setup() {}\nvoid loop() { delay(10); }\n";

/// 60 nested blocks. The next sibling of each block is its own first child, so that a walk over all blocks
/// takes 2^60 steps.
const std::string kOwnSiblings =
    "asm(R\"(.pushsection .debug_abbrev,\"\",@progbits\n"
    "aa: .byte 1,0x11,1,0,0, 2,0x0b,1,1,0x13,0,0, 3,0x0b,0,0,0, 0\n.popsection\n"
    ".pushsection .debug_info,\"\",@progbits\n.long 7+1+60*5+1+62\n.word 4\n.long aa\n.byte 4,1\n"
    ".set i,0\n.rept 60\n.byte 2\n.long 12+5*(i+1)\n.set i,i+1\n.endr\n.byte 3\n.zero 62\n.popsection)\");\n";

/// 200 functions named loop, which share a table of 500,000 addresses.
const std::string kSharedTable =
    "asm(R\"(.pushsection .debug_abbrev,\"\",@progbits\n"
    "aa: .byte 1,0x11,1,0x11,1,0,0, 2,0x2e,0,3,8,0x55,0x17,0,0, 0\n"
    ".section .debug_ranges,\"\",@progbits\nrr: .rept 500000\n.long 0x100,0x102\n.endr\n.long 0,0\n"
    ".section .debug_info,\"\",@progbits\n.long 7+5+200*10+1\n.word 4\n.long aa\n.byte 4,1\n.long 0\n"
    ".rept 200\n.byte 2\n.asciz \"loop\"\n.long rr\n.endr\n.byte 0\n.popsection)\");\n";

using HostileDebugInfoTest = AvrTest;

TEST_F(HostileDebugInfoTest, IsSearchedInABoundedNumberOfSteps) {
  for (const std::string& hostile : {kOwnSiblings, kSharedTable}) {
    start(hostile + kSketch);
    run(20 * kMillisecond);
    EXPECT_FALSE(avr_->crash());
    const DebugInfo debug(built_.image);
    EXPECT_TRUE(debug.is_there());
    EXPECT_LE(debug.code_of("loop").itself.size(), 10'000u);
    debug.lines();
    debug.numbers();
    debug.entries_of("delay");
    EXPECT_EQ(debug.variable_at(0x100).name, "");
    for (std::uint32_t pc = 0x100; pc < 0x200; pc += 2) debug.place(pc);
  }
}

}  // namespace robosim::exec::hostile_debug_info_test
