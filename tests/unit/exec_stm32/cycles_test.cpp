#include "sim/exec/stm32/cycles.h"

#include <gtest/gtest.h>

namespace robosim::exec::stm32::cycles_test {

TEST(Cycles, InstructionsCostWhatTheManualSays) {
  struct Case {
    const char* text;
    std::uint16_t first, second;
    int bytes, cycles;
  };
  for (const Case& c : {Case{"adds r0, r1, r2", 0x1888, 0, 2, 1},
                        Case{"ldr r0, [r1]", 0x6808, 0, 2, 2},
                        Case{"str r0, [sp, #4]", 0x9001, 0, 2, 2},
                        Case{"ldr r3, [pc, #8]", 0x4B02, 0, 2, 2},
                        Case{"push {r4, r5, lr}", 0xB530, 0, 2, 4},
                        Case{"pop {r4, pc}", 0xBD10, 0, 2, 3},
                        Case{"stmia r0!, {r1, r2, r3}", 0xC00E, 0, 2, 4},
                        Case{"bl", 0xF000, 0xF800, 4, 1},
                        Case{"mul.w r0, r1, r2", 0xFB01, 0xF002, 4, 1},
                        Case{"mla r0, r1, r2, r3", 0xFB01, 0x3002, 4, 2},
                        Case{"umull r0, r1, r2, r3", 0xFBA2, 0x0103, 4, 4},
                        Case{"umlal r0, r1, r2, r3", 0xFBE2, 0x0103, 4, 6},
                        Case{"udiv r0, r1, r2", 0xFBB1, 0xF0F2, 4, 7},
                        Case{"ldrd r0, r1, [r2]", 0xE9D2, 0x0100, 4, 3},
                        Case{"push.w {r4-r9, lr}", 0xE92D, 0x43F0, 4, 8},
                        Case{"ldr.w r0, [r1, #4]", 0xF8D1, 0x0004, 4, 2},
                        Case{"mrs r0, primask", 0xF3EF, 0x8010, 4, 2},
                        Case{"dsb", 0xF3BF, 0x8F4F, 4, 4},
                        Case{"cpsid i", 0xB672, 0, 2, 2},
                        Case{"nop", 0xBF00, 0, 2, 1}}) {
    const Instruction i = decode(c.first, c.second);
    EXPECT_EQ(i.bytes, c.bytes) << c.text;
    EXPECT_EQ(i.cycles, c.cycles) << c.text;
  }
}

TEST(Cycles, WhatTheEmulatorMustLookAtIsSeen) {
  EXPECT_TRUE(decode(0xB530, 0).grows_stack) << "push";
  EXPECT_FALSE(decode(0xBD10, 0).grows_stack) << "pop";
  EXPECT_TRUE(decode(0xB084, 0).grows_stack) << "sub sp, #16";
  EXPECT_FALSE(decode(0xB004, 0).grows_stack) << "add sp, #16";
  EXPECT_TRUE(decode(0xE92D, 0x43F0).grows_stack) << "push.w";
  EXPECT_TRUE(decode(0xF5AD, 0x7D00).grows_stack) << "sub.w sp, sp, #512";
  EXPECT_TRUE(decode(0xF84D, 0x4D04).grows_stack) << "str r4, [sp, #-4]!";
  EXPECT_TRUE(decode(0xEBAD, 0x0D01).grows_stack) << "sub.w sp, sp, r1";
  EXPECT_TRUE(decode(0xB662, 0).masks) << "cpsie i";
  EXPECT_TRUE(decode(0xF383, 0x8810).masks) << "msr primask, r3";
  EXPECT_TRUE(decode(0xBF30, 0).sleeps) << "wfi";
  EXPECT_EQ(decode(0xBF08, 0).predicates, 1) << "it eq";
  EXPECT_EQ(decode(0xBF0C, 0).predicates, 2) << "ite eq";
  EXPECT_EQ(decode(0xBF01, 0).predicates, 4) << "itttt eq";
  EXPECT_TRUE(decode(0xFB91, 0xF0F2).divides);
  EXPECT_EQ(decode(0xFB91, 0xF0F2).divisor, 2);
}

}  // namespace robosim::exec::stm32::cycles_test
