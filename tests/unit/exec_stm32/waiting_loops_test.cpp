// Tests that skipping busy-wait loops is not observable. Runs the same program on two emulated chips, and
// compares the chips repeatedly. Only one of the chips skips loops.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "sim/exec/stm32/engine.h"
#include "sim/exec/stm32/machine.h"
#include "tests/support/effort.h"

namespace robosim::exec::stm32::waiting_loops_test {

using namespace robosim::stm32;

constexpr std::uint32_t kCode = kFlash + 0x400, kStack = kRam + kRamBytes - 0x100;
constexpr std::uint32_t kCount = kRam + 0x40, kMemory = kRam + 0x80;

/// Builds machine code, halfword by halfword.
class Program {
 public:
  std::uint32_t here() const { return kCode + 2 * static_cast<std::uint32_t>(code.size()); }
  void half(unsigned op) { code.push_back(static_cast<std::uint16_t>(op)); }
  void load_value(unsigned reg, std::uint32_t value) {  // movw, movt
    for (const unsigned op : {0xF240u, 0xF2C0u}) {
      const std::uint32_t part = op == 0xF240u ? value & 0xFFFF : value >> 16;
      half(op | part >> 12 | (part >> 11 & 1) << 10);
      half((part >> 8 & 7) << 12 | reg << 8 | (part & 0xFF));
    }
  }
  void load(unsigned reg, std::uint32_t address) {
    load_value(7, address);
    half(0x6800 | 7 << 3 | reg);
  }
  void store(std::uint32_t address, unsigned reg) {
    load_value(7, address);
    half(0x6000 | 7 << 3 | reg);
  }
  void put(std::uint32_t address, std::uint32_t value) {
    load_value(0, value);
    store(address, 0);
  }
  /// Adds a branch to `to`, which must be nearby. Condition 14 means always.
  void branch(unsigned condition, std::uint32_t to) {
    const auto offset = (to - here() - 4) / 2;
    half(condition == 14 ? 0xE000 | (offset & 0x7FF) : 0xD000 | condition << 8 | (offset & 0xFF));
  }

  std::vector<std::uint16_t> code;
};

/// A random program with all kinds of wait loops, including loops that no compiler would generate.
class RandomProgram : public Program {
 public:
  explicit RandomProgram(unsigned seed) : engine_(seed) {
    // Each interrupt increments a counter.
    handler_ = here();
    half(0xB403);  // push {r0, r1}
    load_value(0, kCount);
    half(0x6801);  // ldr r1, [r0]
    half(0x3101);  // adds r1, #1
    half(0x6001);  // str r1, [r0]
    half(0xBC03);  // pop {r0, r1}
    half(0x4770);  // bx lr
    function_ = here();
    half(0xB510);  // push {r4, lr}
    junk(3);
    half(0xBD10);  // pop {r4, pc}
    main_ = here();
    if (seed % 2) {  // at 36 MHz a cycle is not a whole number of nanoseconds
      put(kRccCr, kHsiOn | kPllOn);
      put(kRccCfgr, kPllMul9 | kSwPll);
    }
    put(kRccApb2Enr, kIopaEn | kUsart1En | kAdc1En);
    put(kStkLoad, 2000 + below(9000));
    put(kStkVal, 0);
    put(kStkCtrl, below(4) ? 7 : 5);
    put(kUsartBrr, 40 + below(2000));
    put(kUsartCr1, kUe | kTe | kRe);
    put(kAdcCr2, kAdOn | kExtSelSw | kExtTrig);
    const std::uint32_t again = here();
    for (int loop = 0; loop < 4; ++loop) wait();
    load_value(6, again | 1);
    half(0x4730);  // bx r6
  }

  Firmware firmware() const {
    Firmware made;
    made.flash.assign(kFlashBytes, 0xFF);
    const auto put = [&](std::uint32_t at, std::uint32_t value, std::uint32_t bytes) {
      for (std::uint32_t i = 0; i < bytes; ++i)
        made.flash[at - kFlash + i] = static_cast<std::uint8_t>(value >> (8 * i));
    };
    put(kFlash, kStack, 4);
    put(kFlash + 4, main_ | 1, 4);
    for (std::uint32_t vector = 2; vector < 76; ++vector) put(kFlash + 4 * vector, handler_ | 1, 4);
    for (std::size_t i = 0; i < code.size(); ++i) put(kCode + 2 * static_cast<std::uint32_t>(i), code[i], 2);
    made.code_end = here();
    made.globals_end = kRam + 0x100;
    return made;
  }
  /// Returns a random address that counts as the beginning of each round of loop().
  LoopMarks rounds() const {
    LoopMarks rounds;
    rounds.each = {round_};
    return rounds;
  }

 private:
  unsigned below(unsigned count) { return static_cast<unsigned>(engine_() % count); }
  unsigned pick(std::initializer_list<unsigned> of) {
    return *(of.begin() + below(static_cast<unsigned>(of.size())));
  }

  void junk(unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
      const unsigned d = 1 + below(5), m = below(6);
      half(pick({0x4000u, 0x4040u, 0x4140u, 0x4180u, 0x4200u, 0x4240u, 0x4280u, 0x42C0u, 0x4300u, 0x4340u,
                 0x4380u, 0x43C0u, 0x0040u, 0x0840u, 0x1000u, 0x4600u, 0xB280u}) |
           m << 3 | d);
    }
  }

  // Adds a loop of one to four random parts, which ends after one to five interrupts.
  void wait() {
    put(kCount, 0);
    if (below(3) == 0) put(kUsartDr, below(256));
    if (below(3) == 0) put(kAdcCr2, kAdOn | kExtSelSw | kExtTrig | kSwStart);
    if (below(4) == 0) round_ = here();
    const std::uint32_t head = here();
    const unsigned parts = 1 + below(4);
    for (unsigned part = 0; part < parts; ++part) piece();
    load(0, kCount);
    half(0x2800 | (1 + below(5)));  // cmp r0, #n
    branch(3, head);                // bcc
  }

  void piece() {
    const unsigned reg = 1 + below(4);
    switch (below(12)) {
      case 0:
        return load(reg, pick({kUsartSr, kAdcSr, kRccCr, kStkLoad, kScbIcsr, kGpioA + kOdr}));
      case 1:  // reads one pin, or all pins
        return load(reg, below(2) ? bit_band(kGpioA + kIdr, below(16)) : kGpioA + kIdr);
      case 2:
        return store(kMemory + 4 * below(3), reg);
      case 3:
        return load(reg, kMemory + 4 * below(3));
      case 4:
        if (below(6) == 0) return load(reg, pick({kStkVal, kStkCtrl, kUsartDr, kAdcDr}));
        return junk(2);
      case 5:  // counts iterations, with a probability of 1/3
        if (below(3)) return junk(1);
        load(reg, kMemory + 12);
        half(0x3001 | reg << 8);
        return store(kMemory + 12, reg);
      case 6: {  // a function call
        const std::uint32_t offset = function_ - here() - 4;
        half(0xF400 | (offset >> 12 & 0x3FF));
        return half(0xF800 | (offset >> 1 & 0x7FF));
      }
      case 7:  // an IT block
        half(0xBF08 | below(14) << 4);
        return junk(1);
      case 8:  // counts down in an inner loop
        half(0x2500 | (1 + below(20)));
        half(0x3D01);
        return branch(1, here() - 2);
      case 9:
        half(0xB672);  // cpsid i
        if (below(2)) half(0xBF30);
        junk(1);
        return half(0xB662);  // cpsie i
      case 10:
        if (below(3) == 0) return half(0xBF30);  // wfi
        return half(0xB400 | 1u << reg), half(0xBC00 | 1u << reg);
      default:
        return junk(1 + below(4));
    }
  }

  std::mt19937 engine_;
  std::uint32_t handler_ = 0, function_ = 0, main_ = 0, round_ = kCode;
};

/// A source whose level changes occasionally, and which reports the time of its next change.
class Level final : public PinSource {
 public:
  bool level(SimTime t) override { return t / kLasts & 1; }
  SimTime same_until(SimTime t) override { return (t / kLasts + 1) * kLasts; }

 private:
  static constexpr SimTime kLasts = 317 * kMicrosecond;
};

struct Pill {
  explicit Pill(const Firmware& firmware, const LoopMarks& rounds)
      : memory(firmware.flash), engine(memory), machine(firmware, rounds, clocked, memory, engine, 0) {
    for (Pin pin = 0; pin < board.spec().pin_count; ++pin) board.connect(pin, level);
  }

  Level level;
  BoardState board{*find_board("bluepill")};
  ClockedBoard clocked{board};
  FlashMemory memory;
  Engine engine;
  Machine machine;
};

void expect_same(const Machine& skips, const Machine& runs) {
  const Cpu &a = skips.cpu(), &b = runs.cpu();
  ASSERT_EQ(skips.bus().link().clock.now, runs.bus().link().clock.now);
  for (int number = 0; number < Cpu::kPc; ++number) ASSERT_EQ(a.reg(number), b.reg(number)) << "r" << number;
  ASSERT_EQ(a.status(), b.status());
  ASSERT_EQ(a.pc(), b.pc());
  ASSERT_EQ(a.next_pc(), b.next_pc());
  ASSERT_EQ(a.last_io(), b.last_io());
  ASSERT_EQ(a.last_io_pc(), b.last_io_pc());
  ASSERT_EQ(a.last_jumps(), b.last_jumps());
  ASSERT_EQ(a.lowest_sp(), b.lowest_sp());
  ASSERT_EQ(a.handler_cycles(), b.handler_cycles());
  ASSERT_EQ(a.sleep_cycles(), b.sleep_cycles());
  ASSERT_EQ(a.rounds().count(), b.rounds().count());
  ASSERT_EQ(a.rounds().total(), b.rounds().total());
  ASSERT_EQ(a.rounds().longest(0), b.rounds().longest(0));
  ASSERT_EQ(skips.bus().ports().last_read_at(), runs.bus().ports().last_read_at());
  ASSERT_EQ(a.fault().has_value(), b.fault().has_value());
  for (Address at = kRam; at < kRam + 0x100; at += 4) ASSERT_EQ(a.word(at), b.word(at)) << std::hex << at;
  for (Address at = kStack - 0x200; at < kStack; at += 4) ASSERT_EQ(a.word(at), b.word(at)) << std::hex << at;
}

TEST(WaitingLoops, LeaveThePillAsItWouldBe) {
  Cycle skipped = 0, all = 0;
  for (unsigned seed = 1; seed <= test::rounds(200u); ++seed) {
    const RandomProgram program(seed);
    const Firmware firmware = program.firmware();
    Pill skips(firmware, program.rounds()), runs(firmware, program.rounds());
    runs.machine.cpu().idle().allow(false);
    for (SimTime at = 0; at < 25 * kMillisecond && !runs.machine.cpu().fault();) {
      at += 1 + (at * 7919 + seed) % 700'001;
      skips.machine.run_until(at);
      runs.machine.run_until(at);
      ASSERT_NO_FATAL_FAILURE(expect_same(skips.machine, runs.machine)) << "program " << seed << " at " << at;
    }
    skipped += skips.machine.cpu().idle().skipped();
    all += skips.machine.bus().link().clock.now;
    EXPECT_EQ(runs.machine.cpu().idle().skipped(), 0u);
  }
  EXPECT_GT(skipped, all / 8);
}

}  // namespace robosim::exec::stm32::waiting_loops_test
