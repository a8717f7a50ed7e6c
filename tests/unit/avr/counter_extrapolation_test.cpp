// Tests the window that CounterExtrapolation finds: a range of counter values. A computation must take the
// same branches for each counter value in the window. The registers passed to hold(), and the flags passed to
// hold_flags(), must also get the same values.
#include "sim/mcu/avr/counter_extrapolation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "hal/board/atmega328p.h"
#include "tests/unit/avr/random_code.h"

namespace robosim::avr {
namespace counter_extrapolation_test {

constexpr Address kCounter = 0x4A;  // GPIOR1
constexpr Address kMemory = 0x110;

/// Computes multi-byte sums, differences and shifts from a counter, as micros() does.
class Computation : public RandomCode {
 public:
  explicit Computation(unsigned seed) : RandomCode(seed) {
    lds(18, kCounter);
    for (unsigned pieces = 1 + below(5); pieces > 0; --pieces) piece();
    word(0x0000);
  }

 private:
  void piece() {
    const unsigned bytes = 1 + below(4), to = pick({4, 8, 12, 18, 20}), from = pick({4, 8, 12, 18, 18, 20});
    const auto each = [&](auto what) {
      for (unsigned i = 0; i < bytes; ++i) what(i);
    };
    switch (below(14)) {
      case 10:
        word(0xB70F | any() << 4);  // in, SREG
        return;
      case 11:
        word(0x940A | any() << 4);  // dec, which does not change C and H
        return branch(below(6), below(2), here() + 1);
      case 0:
        return each([&](unsigned i) { two(kMov, to + i, from + i); });
      case 1:
      case 2:
        return each([&](unsigned i) { two(i ? kAdc : kAdd, to + i, from + i); });
      case 3:
        return each([&](unsigned i) { two(i ? kSbc : kSub, to + i, from + i); });
      case 4:
        return each([&](unsigned i) { two(i ? kAdc : kAdd, to + i, to + i); });
      case 5: {
        const unsigned upper = pick({18, 20});
        return each([&](unsigned i) { immediate(i ? kSbci : kSubi, upper + i, below(256)); });
      }
      case 6:
        each([&](unsigned i) { two(i ? kCpc : kCp, to + i, from + i); });
        return branch(below(6), below(2), here() + 1);
      case 7:
        immediate(kCpi, 18 + below(4), below(256));
        return branch(below(6), below(2), here() + 1);
      case 8: {
        const unsigned pair = pick({4, 8, 12, 18, 20}) / 2;
        word(0x0100 | 12 << 4 | pair);  // movw r24, pair
        word((below(2) ? 0x9600 : 0x9700) | below(4) << 6 | below(16));
        word(0x0100 | pair << 4 | 12);
        return;
      }
      case 9:
        sts(kMemory + below(3), any());
        return lds(any(), kMemory + below(3));
      case 12:
        word(0x920F | any() << 4);  // push, pop
        word(0x900F | any() << 4);
        return;
      default:
        return junk(1 + below(2));
    }
  }
};

/// The processor's registers after a run, and the branches that it took during the run.
struct Outcome {
  std::vector<std::uint8_t> registers, branches;
  std::uint8_t sreg = 0;
};

class RampTest : public testing::Test {
 protected:
  /// Runs `code`. The initial registers are derived from `seed`. If `follows` is true, `extrapolation_`
  /// observes the run.
  Outcome run(const Program& code, unsigned seed, std::uint8_t counter, bool follows) {
    Cpu& cpu = follows ? *followed_ : *other_;
    std::mt19937 engine(seed);
    for (unsigned reg = 0; reg < 32; ++reg)
      cpu.data[reg] = static_cast<std::uint8_t>(engine() % 3 ? engine() : 0);
    for (Address i = 0; i < 4; ++i) cpu.data[kMemory + i] = static_cast<std::uint8_t>(engine());
    cpu.set_sreg(static_cast<std::uint8_t>(engine() & ~std::uint32_t{Cpu::kI}));
    cpu.set_sp(0x800);
    cpu.data[kCounter] = counter;
    cpu.set_pc(0);
    Outcome outcome;
    while (cpu.pc() < code.here() - 1) {
      const Instruction instruction = cpu.instruction(cpu.pc());
      const InstructionEffects effects = effects_of(instruction, cpu);
      if (instruction.op == Op::brbs || instruction.op == Op::brbc)
        outcome.branches.push_back(cpu.sreg() & instruction.b);
      const bool reads_counter = instruction.op == Op::lds && instruction.k == kCounter;
      if (follows) extrapolation_->follow(instruction, effects);
      cpu.run(cpu.cycle() + 1);
      if (follows && reads_counter) extrapolation_->counter_read(instruction.a);
      if (follows) {
        EXPECT_TRUE(extrapolation_->agrees(~0u)) << "before word " << cpu.pc();
      }
      // The next address shows whether the instruction skipped its successor.
      if (instruction.op == Op::sbrc || instruction.op == Op::sbrs)
        outcome.branches.push_back(static_cast<std::uint8_t>(cpu.pc()));
    }
    outcome.registers.assign(cpu.data.begin(), cpu.data.begin() + 32);
    outcome.sreg = cpu.sreg();
    return outcome;
  }

  void load(const Program& code) {
    followed_ = std::make_unique<Cpu>(kAtmega328p, code.flash, Address{0x8FF});
    other_ = std::make_unique<Cpu>(kAtmega328p, code.flash, Address{0x8FF});
    extrapolation_ = std::make_unique<CounterExtrapolation>(*followed_);
    extrapolation_->begin();
  }

  std::unique_ptr<Cpu> followed_, other_;
  std::unique_ptr<CounterExtrapolation> extrapolation_;
};

TEST_F(RampTest, WhatIsHeldStaysAsItIsWithinTheWindow) {
  int windows = 0;
  for (unsigned seed = 1; seed <= 6000; ++seed) {
    Computation code(seed);
    load(code);
    const auto v0 = static_cast<std::uint8_t>(code.below(code.below(2) ? 256 : 8));
    const Outcome now = run(code, seed, v0, true);
    const unsigned flags = code.below(64);
    const unsigned held = code.below(2) ? code.any() : 32;
    extrapolation_->hold_flags(flags);
    if (held < 32) extrapolation_->hold(static_cast<Address>(held));
    const std::int64_t window = std::min<std::int64_t>(extrapolation_->window(), 255 - v0);
    windows += window > 0;
    for (int n = 1; n <= window;
         n = n < 4 || n + 1 >= window ? n + 1 : std::min<int>(2 * n, static_cast<int>(window) - 1)) {
      const Outcome later = run(code, seed, static_cast<std::uint8_t>(v0 + n), false);
      ASSERT_EQ(now.branches, later.branches) << "computation " << seed << ", " << n << " counts later";
      ASSERT_EQ(now.sreg & flags, later.sreg & flags) << "computation " << seed << ", " << n << " later";
      if (held == 32) continue;
      ASSERT_EQ(now.registers[held], later.registers[held]) << "computation " << seed << ", " << n;
    }
  }
  EXPECT_GT(windows, 1000);
}

}  // namespace counter_extrapolation_test
}  // namespace robosim::avr
