// Compares the emulator with libunicorn, instruction by instruction: registers, flags, RAM and time. An IT
// instruction and its block count as one instruction, and their time is not compared.

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <sstream>

#include "sim/exec/stm32/cpu.h"
#include "sim/exec/stm32/engine.h"

namespace robosim::exec::stm32::thumb_test {

using namespace robosim::stm32;

constexpr std::uint32_t kCode = kFlash + 0x400, kStack = kRam + kRamBytes - 0x400;
constexpr int kLength = 200;

/// A chip whose program begins at kCode.
class Chip {
 public:
  explicit Chip(const Firmware& firmware) : flash_(firmware.flash), cpu(firmware, bus_, engine_, {}) {}

 private:
  BoardState board_{*find_board("bluepill")};
  ClockedBoard clocked_{board_};
  FlashMemory flash_;
  Engine engine_{flash_};
  Bus bus_{clocked_, flash_, 0};

 public:
  Cpu cpu;

  Cycle now() const { return bus_.link().clock.now; }
  void step() { cpu.run_to(now() + 1); }
};

Firmware firmware_of(const std::vector<std::uint16_t>& code) {
  Firmware firmware;
  firmware.flash.assign(kFlashBytes, 0xFF);
  const auto put = [&](std::uint32_t at, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
      firmware.flash[at - kFlash + static_cast<std::uint32_t>(i)] =
          static_cast<std::uint8_t>(value >> (8 * i));
  };
  put(kFlash, kStack, 4);
  put(kFlash + 4, kCode | 1, 4);
  for (std::size_t i = 0; i < code.size(); ++i) put(kCode + 2 * static_cast<std::uint32_t>(i), code[i], 2);
  firmware.code_end = kCode + 2 * static_cast<std::uint32_t>(code.size());
  firmware.globals_end = kRam;
  return firmware;
}

/// Returns random instructions, except jumps and instructions that control the processor.
std::vector<std::uint16_t> random_code(std::mt19937& random) {
  std::vector<std::uint16_t> code;
  int block = 0;  // remaining instructions of an IT block
  while (code.size() < kLength) {
    if (block-- <= 0 && random() % 12 == 0) {
      constexpr unsigned kConditions = 14;
      const unsigned mask = 1 + random() % 15;
      code.push_back(static_cast<std::uint16_t>(0xBF00 | random() % kConditions << 4 | mask));
      block = 4 - std::countr_zero(mask);
    }
    auto first = static_cast<std::uint16_t>(random());
    const auto second = static_cast<std::uint16_t>(random());
    if (random() % 2) first = static_cast<std::uint16_t>(0xE800 | (first & 0x17FF));
    const Thumb thumb = decode_thumb(kCode + 2 * static_cast<std::uint32_t>(code.size()), first, second);
    const bool jumps = thumb.op >= Op::b && thumb.op <= Op::tbh;
    // The program contains no writes to PC. It also contains no additions and moves of high registers: in SP,
    // libunicorn keeps the lowest bits, but the chip clears them (DDI 0403E, B1.4.7).
    const bool to_pc = thumb.d == 15 || thumb.op == Op::add_high || thumb.op == Op::mov_high ||
                       (thumb.op == Op::ldm && thumb.value & 1u << 15);
    // In IT blocks, and shortly after them, the addresses of loads and stores are seldom in RAM. Most of
    // these loads and stores are therefore not added to the program.
    const bool transfers = thumb.op >= Op::ldr && thumb.op <= Op::stm;
    const bool goes_wrong = transfers && block > -4 && random() % 8 != 0;
    if (thumb.op == Op::other || thumb.op >= Op::it || jumps || to_pc || goes_wrong) {
      ++block;
      continue;
    }
    code.push_back(first);
    if (first >= 0xE800) code.push_back(second);
  }
  return code;
}

/// Sets the address registers of most loads and stores so that the addresses are in RAM, but not always
/// aligned.
void find_ram(const Thumb& thumb, std::mt19937& random, Chip& ours, Chip& referee) {
  if (thumb.op < Op::ldr || thumb.op > Op::stm || random() % 200 == 0) return;
  const std::uint32_t base = kRam + 0x1000 + random() % 0x2000, offset = random() % 0x100;
  for (Chip* chip : {&ours, &referee}) {
    if (thumb.n < Cpu::kPc)
      chip->cpu.write_register(thumb.n, thumb.n == Cpu::kSp || thumb.op >= Op::ldrd ? base & ~3u : base);
    if (thumb.op < Op::ldrd && thumb.m < Cpu::kSp && thumb.m != thumb.n)
      chip->cpu.write_register(thumb.m, offset);
  }
}

TEST(Thumb, DoesWhatLibunicornDoes) {
  std::mt19937 random(1);
  int compared = 0, blocks = 0;
  for (int round = 0; round < 90; ++round) {
    const Firmware firmware = firmware_of(random_code(random));
    Chip ours(firmware), referee(firmware);
    referee.cpu.use_referee();
    for (int number = 0; number < Cpu::kLr; ++number) {
      const std::uint32_t address = kRam + 0x800 + random() % 0x3000;
      const std::uint32_t value = random() % 4 == 0   ? random()
                                  : random() % 4 == 0 ? random() % 40
                                                      : address & ~3u;
      for (Chip* chip : {&ours, &referee})
        if (number != Cpu::kSp) chip->cpu.write_register(number, value);
    }
    bool went_wrong_in_block = false;
    while (!ours.cpu.fault() && ours.cpu.next_pc() < firmware.code_end - 80) {
      const std::uint32_t pc = ours.cpu.next_pc();
      const auto thumb_at = [&](std::uint32_t at) {
        return decode_thumb(at, firmware.half(at), firmware.half(at + 2));
      };
      const bool is_block = thumb_at(pc).op == Op::it;
      std::uint32_t end = pc;
      for (int count = decode(firmware.half(pc), 0).predicates; count >= 0; --count) {
        find_ram(thumb_at(end), random, ours, referee);
        end += decode(firmware.half(end), firmware.half(end + 2)).bytes;
      }
      const Cycle began = ours.now(), referee_began = referee.now();
      ours.step();
      referee.step();
      // After an IT block with skipped instructions, one emulator may be ahead. The other emulator then
      // catches up.
      for (int i = 0; i < 16 && (ours.cpu.fault().has_value() != referee.cpu.fault().has_value() ||
                                 ours.cpu.next_pc() != referee.cpu.next_pc());
           ++i) {
        const bool is_behind =
            referee.cpu.fault() || (!ours.cpu.fault() && ours.cpu.next_pc() < referee.cpu.next_pc());
        (is_behind ? ours : referee).step();
      }
      std::ostringstream text;
      text << std::hex << "round " << round << " pc " << pc << ":";
      for (std::uint32_t at = pc; at <= ours.cpu.pc() + 2; at += 2) text << " " << firmware.half(at);
      const std::string where = text.str();
      ASSERT_EQ(ours.cpu.fault().has_value(), referee.cpu.fault().has_value()) << where;
      // After a fault within an IT block, libunicorn executes further instructions. The comparison ends here.
      went_wrong_in_block = ours.cpu.fault() && is_block;
      if (went_wrong_in_block) break;
      for (int number = 0; number < Cpu::kPc; ++number)
        ASSERT_EQ(ours.cpu.reg(number), referee.cpu.reg(number)) << where << " r" << number;
      ASSERT_EQ(ours.cpu.status(), referee.cpu.status()) << where;
      if (!is_block) {
        ASSERT_EQ(ours.now() - began, referee.now() - referee_began) << where;
      }
      ASSERT_EQ(ours.cpu.next_pc(), referee.cpu.next_pc()) << where;
      ++compared;
      blocks += is_block;
    }
    if (went_wrong_in_block) continue;
    for (Address at = kRam; at < kRam + kRamBytes; at += 4)
      ASSERT_EQ(ours.cpu.word(at), referee.cpu.word(at)) << round << " " << std::hex << at;
  }
  EXPECT_GT(compared, 2500);
  EXPECT_GT(blocks, 300);
}

// Saturates values below, within and above the bounds. Random values rarely include all three kinds.
TEST(Thumb, SaturatesAsLibunicornDoes) {
  std::mt19937 random(1);
  std::vector<std::uint16_t> code;
  for (int i = 0; i < 60; ++i) {
    const unsigned shift = random() % 3 == 0 ? random() % 32 : 0;
    code.push_back(static_cast<std::uint16_t>(0xF300 | (i % 2) << 7 | random() % 6));
    code.push_back(static_cast<std::uint16_t>((shift >> 2) << 12 | (6 + random() % 6) << 8 |
                                              (shift & 3) << 6 | random() % 32));
  }
  const Firmware firmware = firmware_of(code);
  Chip ours(firmware), referee(firmware);
  referee.cpu.use_referee();
  const std::uint32_t values[] = {0, 255, 256, 0xFFFFFFFF, 0x80000000, 0x7FFFFFFF};
  for (Chip* chip : {&ours, &referee})
    for (int number = 0; number < 6; ++number) chip->cpu.write_register(number, values[number]);
  while (ours.cpu.next_pc() < firmware.code_end) {
    const std::uint32_t pc = ours.cpu.next_pc();
    ours.step();
    referee.step();
    ASSERT_EQ(ours.cpu.next_pc(), referee.cpu.next_pc());
    for (int number = 0; number < Cpu::kPc; ++number)
      ASSERT_EQ(ours.cpu.reg(number), referee.cpu.reg(number)) << std::hex << pc << " r" << number;
    ASSERT_EQ(ours.cpu.status(), referee.cpu.status()) << std::hex << pc;
    ASSERT_EQ(ours.now(), referee.now()) << std::hex << pc;
  }
}

}  // namespace robosim::exec::stm32::thumb_test
