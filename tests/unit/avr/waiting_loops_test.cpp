// Tests that skipping busy-wait loops is not observable. Runs the same program on two chips, and compares the
// chips repeatedly. Only one of the chips skips loops.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "hal/board/atmega328p.h"
#include "tests/conformance/bench.h"
#include "tests/support/effort.h"
#include "tests/unit/avr/random_code.h"

namespace robosim::avr {
namespace waiting_loops_test {

using conformance::Bench;

constexpr unsigned kTcnt0 = 0x46, kTcnt2 = 0xB2, kAdcsra = 0x7A, kEecr = 0x3F;
constexpr unsigned kCount = 0x100, kMemory = 0x110;  // addresses of a counter and of arbitrary data

/// Programs with all kinds of wait loops, including loops that no compiler would generate.
class RandomProgram : public RandomCode {
 public:
  explicit RandomProgram(unsigned seed) : RandomCode(seed) {
    constexpr unsigned kVectors = 26, kHandler = 2 * kVectors, kMain = kHandler + 40;
    for (unsigned vector = 0; vector < kVectors; ++vector) jmp(vector == 0 ? kMain : kHandler);
    // Each interrupt increments a counter.
    word(0x938F);  // push r24
    word(0xB78F);  // in r24, SREG
    word(0x938F);
    lds(24, kCount);
    immediate(kSubi, 24, 0xFF);
    sts(kCount, 24);
    lds(24, kCount + 1);
    immediate(kSbci, 24, 0xFF);
    sts(kCount + 1, 24);
    word(0x918F);  // pop r24
    word(0xBF8F);  // out SREG, r24
    word(0x918F);
    word(0x9518);  // reti
    function_ = here();
    junk(3);
    word(0x9508);  // ret
    while (here() < kMain) word(0);
    put(0x44, pick({0, 0, 3, 3, 2}));         // TCCR0A
    put(0x47, pick({255, 200, below(256)}));  // OCR0A
    put(0x45, pick({3, 3, 2, 1, 4, 5}));      // TCCR0B
    put(0xB0, pick({0, 3, 1}));               // TCCR2A
    put(0xB1, 1 + below(7));                  // TCCR2B
    put(0x6E, pick({1, 1, 1, 3, 2}));         // TIMSK0
    put(0x7A, 0x87);                          // ADC, by 128
    word(0x9478);                             // sei
    const unsigned again = here();
    for (int loop = 0; loop < 3; ++loop) wait();
    jmp(again);
  }

 private:
  void wait() {
    for (unsigned reg = 2; reg < 24; ++reg) {
      ldi(24, below(3) ? below(256) : 0);
      two(kMov, reg, 24);
    }
    put(kCount, 0);
    put(kCount + 1, 0);
    if (below(3) == 0) put(kAdcsra, 0xC7);
    if (below(4) == 0) put(kEecr, 4), put(kEecr, 2);
    const unsigned head = here();
    if (below(2)) {
      word(0xB77F);  // in r23, SREG: the flags of the previous pass
      if (below(2)) sts(kMemory + 3, 23);
    }
    // The loop ends after some interrupts, even if its other conditions are never met.
    lds(25, kCount);
    immediate(kCpi, 25, 1 + below(6));
    word(0xF000);  // a placeholder for the brcs and jmp below
    const unsigned over = here() - 1;
    word(0);
    word(0);
    const unsigned parts = 1 + below(4);
    for (unsigned part = 0; part < parts; ++part) piece();
    if (below(3) == 0) {
      lds(18, kTcnt0);
      two(below(2) ? kCp : kSub, 18, any());
    }
    if (here() - head < 60 && below(4)) {
      branch(below(6), below(2), head);
      if (below(2)) branch(below(6), below(2), head);
      word(0xC000 | ((head - here() - 1) & 0xFFF));
    } else {
      word(0xC000 | ((head - here() - 1) & 0xFFF));
    }
    const unsigned end = here();
    // Continues the loop with brcs, or leaves the loop with jmp.
    set(over, 0xF000 | 2 << 3);
    set(over + 1, 0x940C);
    set(over + 2, end);
  }

  void set(unsigned at, unsigned word) {
    flash[2 * at] = static_cast<std::uint8_t>(word);
    flash[2 * at + 1] = static_cast<std::uint8_t>(word >> 8);
  }

  void piece() {
    switch (below(10)) {
      case 0:
      case 1:
        return clock(4);
      case 2:
        return clock(2);
      case 3:
        lds(any(), pick({kTcnt0, kTcnt2, kCount, kCount + 1, kMemory, kMemory + 1}));
        return;
      case 4:
        sts(kMemory + below(4), any());
        return;
      case 5:
        lds(upper(), pick({kAdcsra, kEecr, 0x35, 0x37, 0xC0}));
        return;
      case 6:
        if (below(3) == 0) {
          ldi(24, below(256));
          ldi(25, below(3) ? 0 : below(256));
          word(0x9701);  // sbiw r24, 1
          return branch(1, false, here() - 1);
        }
        if (below(2)) return call(function_);
        word(below(2) ? 0xB179 : 0xB189);  // in r23 or r24, PIND
        return immediate(kAndi, 23, 1 << below(8));
      case 7:
        word(0x9B00 | pick({0x15, 0x17, 0x09}) << 3 | below(3));  // sbis TIFR0, TIFR2 or PIND, bit
        word(below(2) ? 0 : 0x9553);                              // nop; inc r21
        return;
      default:
        return junk(1 + below(4));
    }
  }

  /// Adds code that reads a counter into the bytes of a number, as micros() does.
  void clock(unsigned bytes) {
    const unsigned to = bytes == 4 ? pick({4, 8, 12, 20}) : pick({4, 6, 20});
    const bool saves = below(2);
    if (saves) {
      word(0xB73F);  // in r19, SREG
      word(0x94F8);  // cli
    }
    lds(18, below(4) ? kTcnt0 : kTcnt2);
    if (saves) word(0xBF3F);  // out SREG, r19
    if (below(2)) {
      two(kMov, to, 18);
      for (unsigned i = 1; i < bytes; ++i) {
        if (below(2)) {
          two(kEor, to + i, to + i);
        } else {
          lds(to + i, kCount + below(2));
        }
      }
    } else {
      ldi(24, below(256));
      for (unsigned i = 0; i < bytes; ++i) two(kMov, to + i, 24);
      ldi(25, 0);
      two(kAdd, to, 18);
      for (unsigned i = 1; i < bytes; ++i) two(kAdc, to + i, 25);
    }
    for (unsigned shifts = below(4); shifts > 0; --shifts)
      for (unsigned i = 0; i < bytes; ++i) two(i ? kAdc : kAdd, to + i, to + i);
    if (below(2)) {
      const unsigned from = to == 4 ? 12 : 4;
      const bool less = below(2);
      for (unsigned i = 0; i < bytes; ++i) two(less ? (i ? kSbc : kSub) : i ? kAdc : kAdd, to + i, from + i);
    }
    if (bytes == 2 && below(3) == 0) {
      two(0x0100, 12, to / 2);  // movw r24, to
      word((below(2) ? 0x9600 : 0x9700) | below(4) << 6 | below(16));
      two(0x0100, to / 2, 12);
    }
    if (to >= 16 && below(2)) {
      for (unsigned i = 0; i < bytes; ++i)
        immediate(i + 1 == bytes || below(2) ? (i ? kSbci : kSubi)
                  : i                        ? kSbci
                                             : kSubi,
                  to + i, i < 2 ? below(256) : 0);
    }
    if (below(4) == 0) {
      word(0x920F | to << 4);  // push, pop
      word(0x900F | (to + below(2)) << 4);
    }
    if (below(3)) {
      const unsigned against = to == 4 ? 8 : 4;
      for (unsigned i = 0; i < bytes; ++i) two(i ? kCpc : kCp, to + i, against + i);
    }
  }

  unsigned function_ = 0;
};

void expect_same(Bench& skips, Bench& runs) {
  const Cpu::State &a = skips.chip.cpu().state, &b = runs.chip.cpu().state;
  ASSERT_EQ(a.cycle, b.cycle);
  ASSERT_EQ(a.pc, b.pc);
  ASSERT_EQ(a.sp, b.sp);
  ASSERT_EQ(a.sreg, b.sreg);
  ASSERT_EQ(a.last_pc, b.last_pc);
  ASSERT_EQ(a.last_io, b.last_io);
  ASSERT_EQ(a.last_io_pc, b.last_io_pc);
  ASSERT_EQ(a.jump_count, b.jump_count);
  ASSERT_EQ(a.jumps, b.jumps);
  ASSERT_EQ(a.handler_cycles, b.handler_cycles);
  ASSERT_EQ(skips.chip.cpu().data, runs.chip.cpu().data);
  ASSERT_EQ(skips.chip.core().events.state.due, runs.chip.core().events.state.due);
}

TEST(WaitingLoops, LeaveTheChipAsItWouldBe) {
  Cycle skipped = 0, all = 0;
  for (unsigned seed = 1; seed <= test::rounds(200u); ++seed) {
    RandomProgram program(seed);
    program.flash.resize(kAtmega328p.flash_bytes, 0xFF);
    Bench skips(kAtmega328p, program.flash), runs(kAtmega328p, program.flash);
    runs.chip.idle().allow(false);
    for (Cycle at = 0; at < 600'000; at += 1 + (at * 7919 + seed) % 20'011) {
      const int pin = skips.chip.pins().at('D', static_cast<int>(at % 8));
      for (Bench* bench : {&skips, &runs}) bench->set_level(pin, at & 16);
      ASSERT_EQ(skips.chip.run_to(at), runs.chip.run_to(at)) << "program " << seed << " at " << at;
      ASSERT_NO_FATAL_FAILURE(expect_same(skips, runs)) << "program " << seed << " at " << at;
    }
    skipped += skips.chip.idle().skipped();
    all += skips.chip.cycle();
    EXPECT_EQ(runs.chip.idle().skipped(), 0u);
  }
  EXPECT_GT(skipped, all / 8);
}

TEST(WaitingLoops, ThatCountDownAreRunThroughAsOneByOne) {
  Program program;
  program.word(0x0000);
  program.word(0x9701);  // sbiw r24, 1
  program.branch(1, false, 1);
  program.word(0xCFFC);  // rjmp to the start
  std::mt19937 engine(7);
  for (int trial = 0; trial < test::rounds(3000); ++trial) {
    Cpu at_once(kAtmega328p, program.flash, Address{0x8FF}),
        one_by_one(kAtmega328p, program.flash, Address{0x8FF});
    const unsigned ends[] = {0, 1, 2, 0x7FFF, 0x8000, 0x8001, 0xFFFF};
    const unsigned count = engine() % 2 ? ends[engine() % 7] : engine() % 3000;
    for (Cpu* cpu : {&at_once, &one_by_one}) {
      cpu->data[24] = static_cast<std::uint8_t>(count);
      cpu->data[25] = static_cast<std::uint8_t>(count >> 8);
      cpu->set_sreg(0x60);
    }
    for (Cycle until : {Cycle{engine() % 40}, Cycle{engine() % 20'000}, Cycle{engine() % 300'000}}) {
      at_once.run(until);
      while (one_by_one.cycle() < until) one_by_one.run(one_by_one.cycle() + 1);
      ASSERT_EQ(at_once.cycle(), one_by_one.cycle()) << "from " << count;
      ASSERT_EQ(at_once.pc(), one_by_one.pc()) << "from " << count << " to " << until;
      ASSERT_EQ(at_once.sreg(), one_by_one.sreg()) << "from " << count << " to " << until;
      ASSERT_EQ(at_once.pair(24), one_by_one.pair(24)) << "from " << count << " to " << until;
    }
  }
}

}  // namespace waiting_loops_test
}  // namespace robosim::avr
