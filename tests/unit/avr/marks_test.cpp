// Tests marks, which are the processor's breakpoints. A mark stops the processor before an instruction. It
// does so even between two instructions that the processor would otherwise execute in one step.
#include <gtest/gtest.h>

#include "hal/board/atmega328p.h"
#include "sim/mcu/avr/cpu.h"

namespace robosim::avr {
namespace marks_test {

// add r0, r1; adc r2, r3; adc r4, r5; lds r16, 0x0100; lds r17, 0x0101; rjmp .-2
constexpr std::uint8_t kProgram[] = {0x01, 0x0C, 0x23, 0x1C, 0x45, 0x1C, 0x00, 0x91,
                                     0x00, 0x01, 0x10, 0x91, 0x01, 0x01, 0xFF, 0xCF};
constexpr std::uint32_t kEnd = 7;

class Marks : public testing::Test {
 protected:
  Marks() {
    for (Address address = 0; address < 6; ++address) cpu.data[address] = 0x90;
    cpu.data[0x100] = 0x11;
    cpu.data[0x101] = 0x22;
  }
  Cpu cpu{kAtmega328p, kProgram, 0x8FF};
};

TEST_F(Marks, StopInFrontOfEachInstruction) {
  for (const std::uint32_t pc : {1u, 2u, 3u, 5u, kEnd}) {
    cpu.set_mark(pc, true);
    ASSERT_EQ(cpu.run(cpu.cycle() + 100), Cpu::Stop::mark);
    EXPECT_EQ(cpu.pc(), pc);
  }
  EXPECT_EQ(cpu.cycle(), 7u);
}

TEST_F(Marks, ShowTheFlagsOfTheInstructionBefore) {
  cpu.set_mark(1, true);
  cpu.run(100);
  EXPECT_EQ(cpu.sreg(), Cpu::kC | Cpu::kV | Cpu::kS) << "0x90 + 0x90";
}

TEST_F(Marks, LeaveNothingBehindWhenTheyAreTakenAway) {
  cpu.set_mark(1, true);
  cpu.set_mark(5, true);
  cpu.set_mark(1, false);
  cpu.set_mark(5, false);
  cpu.set_mark(kEnd, true);
  ASSERT_EQ(cpu.run(100), Cpu::Stop::mark);
  EXPECT_EQ(cpu.pc(), kEnd);
  EXPECT_EQ(cpu.data[2], 0x21);
  EXPECT_EQ(cpu.data[16] << 8 | cpu.data[17], 0x1122);
}

TEST_F(Marks, StopAgainWhereOneWasTakenAwayAndPutBack) {
  cpu.set_mark(kEnd, true);
  ASSERT_EQ(cpu.run(100), Cpu::Stop::mark);
  cpu.set_mark(kEnd, false);
  for (Cycle until = 100; cpu.pc() != kEnd || cpu.cycle() < 100; ++until) cpu.run(until);
  cpu.set_mark(kEnd, true);
  ASSERT_EQ(cpu.run(cpu.cycle() + 1), Cpu::Stop::mark);
  EXPECT_EQ(cpu.pc(), kEnd);
}

TEST_F(Marks, MayBePutBehindAnInstructionThatHasRun) {
  for (const Cycle until : {1u, 2u}) cpu.run(until);
  cpu.set_mark(2, true);
  EXPECT_EQ(cpu.run(100), Cpu::Stop::mark);
  EXPECT_EQ(cpu.cycle(), 2u);
}

}  // namespace marks_test
}  // namespace robosim::avr
