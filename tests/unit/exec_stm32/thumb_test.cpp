// Instructions, one after the other, as we execute them and as libunicorn does: the same registers, flags,
// RAM and time.

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <sstream>

#include "sim/exec/stm32/cpu.h"

namespace robosim::exec::stm32 {
namespace {

using namespace robosim::stm32;

constexpr std::uint32_t kCode = kFlash + 0x400, kStack = kRam + kRamBytes - 0x400;
constexpr int kLength = 200;

/// A chip that begins at kCode.
class Chip {
 public:
  explicit Chip(const Firmware& firmware) : flash_(firmware.flash), cpu(firmware, bus_, {}) {}

 private:
  BoardState board_{*find_board("bluepill")};
  ClockedBoard clocked_{board_};
  FlashMemory flash_;
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

/// Instructions that we know, but for those that jump, or concern the processor itself (IT among them).
std::vector<std::uint16_t> random_code(std::mt19937& random) {
  std::vector<std::uint16_t> code;
  while (code.size() < kLength) {
    auto first = static_cast<std::uint16_t>(random());
    const auto second = static_cast<std::uint16_t>(random());
    if (random() % 2) first = static_cast<std::uint16_t>(0xE800 | (first & 0x17FF));
    const Thumb thumb = decode_thumb(kCode + 2 * static_cast<std::uint32_t>(code.size()), first, second);
    const bool jumps = thumb.op >= Op::b && thumb.op <= Op::tbh;
    // libunicorn keeps the lowest bits of an SP that is moved to; the chip has none (B1.4.7).
    const bool to_pc = thumb.d == 15 || thumb.op == Op::add_high || thumb.op == Op::mov_high ||
                       (thumb.op == Op::ldm && thumb.value & 1u << 15);
    if (thumb.op == Op::other || thumb.op >= Op::it || jumps || to_pc) continue;
    code.push_back(first);
    if (first >= 0xE800) code.push_back(second);
  }
  return code;
}

TEST(Thumb, DoesWhatLibunicornDoes) {
  std::mt19937 random(1);
  int compared = 0;
  for (int round = 0; round < 60; ++round) {
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
    while (!ours.cpu.fault() && ours.cpu.next_pc() < firmware.code_end - 4) {
      const std::uint32_t pc = ours.cpu.next_pc();
      const Thumb thumb = decode_thumb(pc, firmware.half(pc), firmware.half(pc + 2));
      const bool transfers = thumb.op >= Op::ldr && thumb.op <= Op::stm;
      const bool in_ram = random() % 50 != 0;
      const std::uint32_t base = kRam + 0x1000 + random() % 0x2000, offset = random() % 0x100;
      for (Chip* chip : {&ours, &referee}) {
        // Most loads and stores find RAM, not always aligned.
        if (transfers && thumb.n < Cpu::kPc && in_ram)
          chip->cpu.write_register(thumb.n, thumb.n == Cpu::kSp || thumb.op >= Op::ldrd ? base & ~3u : base);
        if (transfers && thumb.op < Op::ldrd && thumb.m < Cpu::kSp && thumb.m != thumb.n)
          chip->cpu.write_register(thumb.m, offset);
        chip->step();
      }
      std::ostringstream text;
      text << std::hex << "round " << round << " pc " << pc << ":";
      for (std::uint32_t at = pc; at <= ours.cpu.pc() + 2; at += 2) text << " " << firmware.half(at);
      const std::string where = text.str();
      for (int number = 0; number < Cpu::kPc; ++number)
        ASSERT_EQ(ours.cpu.reg(number), referee.cpu.reg(number)) << where << " r" << number;
      ASSERT_EQ(ours.cpu.status(), referee.cpu.status()) << where;
      ASSERT_EQ(ours.now(), referee.now()) << where;
      ASSERT_EQ(ours.cpu.next_pc(), referee.cpu.next_pc()) << where;
      ASSERT_EQ(ours.cpu.fault().has_value(), referee.cpu.fault().has_value()) << where;
      ++compared;
    }
    for (Address at = kRam; at < kRam + kRamBytes; at += 4)
      ASSERT_EQ(ours.cpu.word(at), referee.cpu.word(at)) << round << " " << std::hex << at;
  }
  EXPECT_GT(compared, 3000);
}

}  // namespace
}  // namespace robosim::exec::stm32
