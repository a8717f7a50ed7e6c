// Tests the detection of endless loops, and of the memory that an interrupt handler may change.
#include "sim/mcu/avr/infinite_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "hal/board/atmega328p.h"
#include "tests/unit/avr/random_code.h"

namespace robosim::avr {
namespace infinite_loop_test {

constexpr Address kFlag = 0x110, kOther = 0x111;
constexpr unsigned kBack = 0xCFFF, kReti = 0x9518;
constexpr int kMost = 10'000, kVector = 3;

/// Builds a program at word address 0x80, and an interrupt handler at word address 0x40.
class RecurrenceTest : public testing::Test {
 protected:
  RecurrenceTest() {
    while (code_.here() < 2 * kVector) code_.word(0);
    code_.jmp(0x40);
  }
  void handler() { fill(0x40); }
  void program() { fill(0x80); }
  void fill(unsigned to) {
    while (code_.here() < to) code_.word(0);
  }
  /// Adds the last instruction of a loop, which jumps back to `to`.
  void back(unsigned to) { code_.word(0xC000 | ((to - code_.here() - 1) & 0xFFF)); }

  std::optional<InfiniteLoop> round() {
    cpu_ = std::make_unique<Cpu>(kAtmega328p, code_.flash, Address{0x8FF});
    cpu_->set_pc(0x80);
    cpu_->set_sp(0x8FF);
    cpu_->set_sreg(Cpu::kI);
    return find_infinite_loop(*cpu_, kMost);
  }
  std::optional<Stores> stores() {
    cpu_ = std::make_unique<Cpu>(kAtmega328p, code_.flash, Address{0x8FF});
    return stores_of_handler(*cpu_, kVector);
  }

  Program code_;
  std::unique_ptr<Cpu> cpu_;
};

TEST_F(RecurrenceTest, AJumpToItselfIsARoundThatReadsNothing) {
  program();
  code_.word(kBack);
  const auto found = round();
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->interruptible);
  EXPECT_EQ(std::ranges::count(found->reads, true), 0);
  EXPECT_EQ(cpu_->pc(), 0x80u) << "the processor itself has not moved";
}

TEST_F(RecurrenceTest, ARoundTellsWhatItReadsAndWhetherInterruptsMayComeIn) {
  program();
  code_.lds(24, kOther);  // runs once, before the loop
  code_.word(0x94F8);     // cli
  const unsigned head = code_.here();
  code_.lds(24, kFlag);
  back(head);
  const auto found = round();
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->interruptible);
  EXPECT_TRUE(found->reads[kFlag]);
  EXPECT_FALSE(found->reads[kOther]);
}

TEST_F(RecurrenceTest, ACounterOfAByteComesRoundAndOneOfThreeBytesDoesNotInTime) {
  for (const unsigned bytes : {1u, 3u}) {
    code_ = Program();
    program();
    const unsigned head = code_.here();
    code_.immediate(kSubi, 20, 1);
    for (unsigned i = 1; i < bytes; ++i) code_.immediate(kSbci, 20 + i, 0);
    code_.sts(kFlag, 20);
    back(head);
    EXPECT_EQ(round().has_value(), bytes == 1);
  }
}

TEST_F(RecurrenceTest, NothingIsToldOfAProgramThatLooksAtIoOrSleeps) {
  for (const unsigned look : {0xB103u /* in r16, PINB */, 0x9588u /* sleep */, 0x95A8u /* wdr */}) {
    code_ = Program();
    program();
    const unsigned head = code_.here();
    code_.word(look);
    back(head);
    EXPECT_FALSE(round()) << std::hex << look;
  }
}

TEST_F(RecurrenceTest, AHandlerOfFixedVariablesIsToldWhicheverWayItBranches) {
  handler();
  code_.word(0x920F);         // push r0
  code_.word(0xB600 | 0x0F);  // in r0, SREG
  code_.lds(24, kOther);
  code_.branch(1, true, code_.here() + 3);
  code_.sts(kFlag, 24);
  code_.word(0xBE0F);  // out SREG, r0
  code_.word(0x900F);  // pop r0
  code_.word(kReti);
  const auto found = stores();
  ASSERT_TRUE(found);
  EXPECT_TRUE((*found)[kFlag]);
  EXPECT_EQ(std::ranges::count(*found, true), 1);
}

TEST_F(RecurrenceTest, AHandlerThatCallsOrStoresByPointerOrTouchesIoMayDoAnything) {
  for (const unsigned deed : {0x9509u /* icall */, 0x9409u /* ijmp */, 0xD010u /* rcall */,
                              0x938Cu /* st X */, 0x9A28u /* sbi */, 0xB985u /* out */, 0x8188u /* ld Y */}) {
    code_ = Program();
    while (code_.here() < 2 * kVector) code_.word(0);
    code_.jmp(0x40);
    handler();
    code_.word(deed);
    code_.word(kReti);
    EXPECT_FALSE(stores()) << std::hex << deed;
  }
}

}  // namespace infinite_loop_test
}  // namespace robosim::avr
