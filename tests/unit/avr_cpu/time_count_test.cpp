// Tests the Arduino core's timer 0 handler, and the code with which millis() reads the time. The processor
// executes each of them in one step. The result must equal that of single instructions.
#include <gtest/gtest.h>

#include <random>
#include <span>

#include "hal/board/atmega328p.h"
#include "sim/mcu/avr/cpu.h"

namespace robosim::avr {
namespace time_count_test {

// The timer 0 handler of the Arduino core (wiring.c). Its variables are the milliseconds at 0x105, their
// fraction at 0x104, and the overflows at 0x100. The handler returns to the preceding `sei; rjmp .-4`.
constexpr std::uint16_t kTimeProgram[] = {
    0x9478, 0xCFFE, 0x921F, 0x920F, 0xB60F, 0x920F, 0x2411, 0x932F, 0x933F, 0x938F, 0x939F, 0x93AF, 0x93BF,
    0x9180, 0x0105, 0x9190, 0x0106, 0x91A0, 0x0107, 0x91B0, 0x0108, 0x9130, 0x0104, 0xE023, 0x0F23, 0x372D,
    0xF420, 0x9601, 0x1DA1, 0x1DB1, 0xC005, 0xE826, 0x0F23, 0x9602, 0x1DA1, 0x1DB1, 0x9320, 0x0104, 0x9380,
    0x0105, 0x9390, 0x0106, 0x93A0, 0x0107, 0x93B0, 0x0108, 0x9180, 0x0100, 0x9190, 0x0101, 0x91A0, 0x0102,
    0x91B0, 0x0103, 0x9601, 0x1DA1, 0x1DB1, 0x9380, 0x0100, 0x9390, 0x0101, 0x93A0, 0x0102, 0x93B0, 0x0103,
    0x91BF, 0x91AF, 0x919F, 0x918F, 0x913F, 0x912F, 0x900F, 0xBE0F, 0x900F, 0x901F, 0x9518};
constexpr std::uint32_t kTimeHandler = 2;
// Reads a number as millis() does: in r18,SREG; cli; lds r22 to r25; out SREG,r18; rjmp back
constexpr std::uint16_t kNumberProgram[] = {0xB72F, 0x94F8, 0x9160, 0x0105, 0x9170, 0x0106,
                                            0x9180, 0x0107, 0x9190, 0x0108, 0xBF2F, 0xCFF4};
constexpr Address kRamEnd = 0x8FF;

class CountsTime : public testing::Test {
 protected:
  explicit CountsTime(std::span<const std::uint16_t> program = kTimeProgram) {
    for (const std::uint16_t word : program) {
      flash_.push_back(static_cast<std::uint8_t>(word));
      flash_.push_back(static_cast<std::uint8_t>(word >> 8));
    }
  }
  Cpu cpu() const {
    Cpu made(kAtmega328p, flash_, kRamEnd);
    made.waiting = &none_;
    return made;
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }

  /// Sets the program counter to the start of the handler, and the rest of the state to random values. In
  /// most cases, interrupts are off and one handler is running, as after an interrupt.
  void shuffle(Cpu& one) {
    for (std::uint8_t& data : one.data) data = random_() % 3 == 0 ? 0xFF : byte();
    one.data[0x104] = static_cast<std::uint8_t>(random_() % 128);
    Cpu::State& state = one.state;
    state = {};
    state.cycle = 1000;
    state.sp =
        static_cast<std::uint16_t>(random_() % 8 == 0 ? 0xFE + random_() % 32 : kRamEnd - random_() % 40);
    state.sp_watch = static_cast<std::uint16_t>(random_() % 4 == 0 ? state.sp - random_() % 12 : 0x100);
    one.data[state.sp + 1u > kRamEnd ? kRamEnd : state.sp + 1u] = 0;
    one.data[state.sp + 2u > kRamEnd ? kRamEnd : state.sp + 2u] = static_cast<std::uint8_t>(random_() % 2);
    state.sreg = byte();
    if (random_() % 8 != 0) state.sreg &= static_cast<std::uint8_t>(~Cpu::kI);
    state.open_handlers = random_() % 8 == 0 ? 0 : 1;
    state.pc = kTimeHandler;
  }
  static void expect_same(const Cpu& a, const Cpu& b) {
    EXPECT_EQ(a.data, b.data);
    const Cpu::State &x = a.state, &y = b.state;
    EXPECT_EQ(std::tie(x.cycle, x.pc, x.last_pc, x.sp, x.sreg, x.held_at, x.open_handlers, x.handler_cycles),
              std::tie(y.cycle, y.pc, y.last_pc, y.sp, y.sreg, y.held_at, y.open_handlers, y.handler_cycles));
    EXPECT_EQ(std::tie(x.last_io, x.last_io_pc, x.jumps, x.jump_count),
              std::tie(y.last_io, y.last_io_pc, y.jumps, y.jump_count));
  }

  std::mt19937 random_{1};
  std::vector<std::uint8_t> flash_;
  const std::uint64_t none_ = 0;
};

TEST_F(CountsTime, AtOnceAsItsInstructionsDo) {
  Cpu whole = cpu(), single = cpu();
  int counted = 0;
  for (int i = 0; i < 5'000; ++i) {
    shuffle(whole);
    single.data = whole.data;
    single.state = whole.state;
    const Cycle until = whole.cycle() + (random_() % 2 ? random_() % 110 : 92 + random_() % 6);
    const std::uint8_t overflows = whole.data[0x100];
    const Cpu::Stop stop = whole.run(until);
    Cpu::Stop one = Cpu::Stop::reached;
    while (single.cycle() < until && one == Cpu::Stop::reached) one = single.run(single.cycle() + 1);
    EXPECT_EQ(stop, one);
    expect_same(whole, single);
    ASSERT_FALSE(HasFailure()) << "run " << i;
    counted += whole.data[0x100] != overflows;
  }
  EXPECT_GT(counted, 1'000);
}

TEST_F(CountsTime, AndStopsAtAMarkInTheMiddle) {
  for (const std::uint32_t place : {kTimeHandler, kTimeHandler + 1, kTimeHandler + 21, kTimeHandler + 73}) {
    Cpu one = cpu();
    shuffle(one);
    one.state.open_handlers = 1;
    one.state.sp = kRamEnd - 20;
    one.state.sp_watch = 0x200;
    one.set_mark(place, true);
    ASSERT_EQ(one.run(2000), Cpu::Stop::mark);
    EXPECT_EQ(one.pc(), place);
  }
}

// A loop (sei; rjmp .-4), two nops, an interrupt vector (jmp 6), and the handler.
const std::vector<std::uint16_t> kVectorProgram = [] {
  std::vector<std::uint16_t> words{0x9478, 0xCFFE, 0, 0, 0x940C, 6};
  words.insert(words.end(), std::begin(kTimeProgram) + kTimeHandler, std::end(kTimeProgram));
  return words;
}();

class CountsTimeByInterrupt : public CountsTime {
 protected:
  CountsTimeByInterrupt() : CountsTime(kVectorProgram) {}
};

TEST_F(CountsTimeByInterrupt, AtOnceAsItsInstructionsDo) {
  Cpu whole = cpu(), single = cpu();
  int counted = 0;
  for (int i = 0; i < 5'000; ++i) {
    shuffle(whole);
    whole.state.pc = static_cast<std::uint32_t>(random_() % 2);
    single.data = whole.data;
    single.state = whole.state;
    const Cycle until = whole.cycle() + 85 + random_() % 60;
    const std::uint8_t overflows = whole.data[0x100];
    whole.enter(2);
    whole.count_time(until);
    counted += whole.data[0x100] != overflows;
    Cpu::Stop stop = Cpu::Stop::reached, one = stop;
    while (whole.cycle() < until && stop == Cpu::Stop::reached) stop = whole.run(until);
    single.enter(2);
    while (single.cycle() < until && one == Cpu::Stop::reached) one = single.run(single.cycle() + 1);
    EXPECT_EQ(stop, one);
    expect_same(whole, single);
    ASSERT_FALSE(HasFailure()) << "run " << i;
  }
  EXPECT_GT(counted, 1'000);
}

class ReadsNumber : public CountsTime {
 protected:
  ReadsNumber() : CountsTime(kNumberProgram) {}
};

TEST_F(ReadsNumber, AtOnceAsItsInstructionsDo) {
  Cpu whole = cpu(), single = cpu();
  for (int i = 0; i < 5'000; ++i) {
    shuffle(whole);
    whole.state.pc = 0;
    const std::uint64_t waiting = random_() % 4 == 0;
    single.data = whole.data;
    single.state = whole.state;
    whole.waiting = single.waiting = &waiting;
    const Cycle until = whole.cycle() + random_() % 40;
    while (whole.cycle() < until) ASSERT_EQ(whole.run(until), Cpu::Stop::reached);
    while (single.cycle() < until) ASSERT_EQ(single.run(single.cycle() + 1), Cpu::Stop::reached);
    expect_same(whole, single);
    ASSERT_FALSE(HasFailure()) << "run " << i;
  }
}

TEST_F(ReadsNumber, AndStopsAtAMarkInTheMiddle) {
  for (std::uint32_t place : {0u, 1u, 4u, 10u}) {
    Cpu one = cpu();
    one.set_mark(place, true);
    ASSERT_EQ(one.run(100), Cpu::Stop::mark);
    EXPECT_EQ(one.pc(), place);
  }
}

}  // namespace time_count_test
}  // namespace robosim::avr
