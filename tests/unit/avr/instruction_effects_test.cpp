// Tests effects_of() against the processor. Each instruction writes only the registers, flags and memory that
// effects_of() lists. Its results depend only on the registers and flags that effects_of() lists.
#include "sim/mcu/avr/instruction_effects.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "hal/board/atmega2560.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::avr {
namespace instruction_effects_test {

constexpr std::uint32_t kAllWords = 0x10000;
constexpr Address kRam = 0x200, kRamEnd = 0x21FF, kStack = 0x1800;

/// A chip whose flash contains every possible opcode: each word from 0 to 0xFFFF equals its own address.
class InstructionEffectsTest : public testing::Test {
 protected:
  static std::vector<std::uint8_t> all_words() {
    std::vector<std::uint8_t> flash(kAtmega2560.flash_bytes, 0);
    for (std::uint32_t word = 0; word < kAllWords; ++word) {
      flash[2 * word] = static_cast<std::uint8_t>(word);
      flash[2 * word + 1] = static_cast<std::uint8_t>(word >> 8);
    }
    return flash;
  }

  struct State {
    std::vector<std::uint8_t> data;
    std::uint8_t flags = 0;
  };
  State random_state() {
    State state{std::vector<std::uint8_t>(32),
                static_cast<std::uint8_t>(engine_() & ~std::uint32_t{Cpu::kI})};
    for (std::uint8_t& reg : state.data) reg = static_cast<std::uint8_t>(engine_());
    for (const unsigned pointer : {27u, 29u, 31u})  // high bytes of X, Y and Z: addresses in RAM
      state.data[pointer] = static_cast<std::uint8_t>(0x04 + engine_() % 0x10);
    return state;
  }
  void set(const State& state, std::uint32_t pc) {
    std::copy(state.data.begin(), state.data.end(), cpu_.data.begin());
    cpu_.set_sreg(state.flags);
    cpu_.set_sp(kStack);
    cpu_.set_pc(pc);
  }
  /// Calls visit(pc, instruction, state, effects) before each instruction, with the chip in a random state.
  /// Skips instructions that access data memory outside RAM, or affect more than registers, flags and data
  /// memory.
  template <typename Visit>
  void each_instruction(Visit visit) {
    for (std::uint32_t pc = 2; pc < kAllWords && !HasFatalFailure(); ++pc) {
      const Instruction& i = cpu_.instruction(pc);
      const State state = random_state();
      set(state, pc);
      const InstructionEffects e = effects_of(i, cpu_);
      const bool is_in_ram = e.memory == InstructionEffects::Memory::none ||
                             (e.address >= kRam && e.address + e.bytes <= kRamEnd);
      if (!e.elsewhere && is_in_ram) visit(pc, i, state, e);
    }
  }

  Cpu cpu_{kAtmega2560, all_words(), kRamEnd};
  std::mt19937 engine_{1};
};

TEST_F(InstructionEffectsTest, AreAllThatAnInstructionChanges) {
  int run = 0;
  each_instruction(
      [&](std::uint32_t pc, const Instruction&, const State& before, const InstructionEffects& e) {
        const std::vector<std::uint8_t> memory = cpu_.data;
        cpu_.run(cpu_.cycle() + 1);
        ++run;
        std::string extra;
        for (unsigned reg = 0; reg < 32; ++reg)
          if (cpu_.data[reg] != before.data[reg] && !(e.writes >> reg & 1))
            extra += " r" + std::to_string(reg);
        if ((cpu_.sreg() ^ before.flags) & ~e.flags_written) extra += " flags";
        for (Address at = kRam; at < kRamEnd; ++at) {
          const bool is_stored =
              e.memory == InstructionEffects::Memory::store && at >= e.address && at < e.address + e.bytes;
          if (cpu_.data[at] != memory[at] && !is_stored) extra += " memory";
        }
        ASSERT_EQ(extra, "") << "word " << std::hex << pc;
      });
  EXPECT_GT(run, 55'000);
}

TEST_F(InstructionEffectsTest, AreAllThatItsResultsDependOn) {
  each_instruction(
      [&](std::uint32_t pc, const Instruction&, const State& before, const InstructionEffects& e) {
        cpu_.run(cpu_.cycle() + 1);
        const std::vector<std::uint8_t> data = cpu_.data;
        const std::uint8_t flags = cpu_.sreg();
        const std::uint32_t next = cpu_.pc();
        State other = before;  // inverts all registers and flags that the instruction does not read
        for (unsigned reg = 0; reg < 32; ++reg)
          if (!(e.reads >> reg & 1)) other.data[reg] = static_cast<std::uint8_t>(~other.data[reg]);
        const std::uint8_t free_flags = static_cast<std::uint8_t>(~e.flags_read & ~Cpu::kI);
        other.flags ^= free_flags;
        set(other, pc);
        cpu_.run(cpu_.cycle() + 1);
        ASSERT_EQ(cpu_.pc(), next) << "word " << std::hex << pc;
        for (unsigned reg = 0; reg < 32; ++reg) {
          if (e.writes >> reg & 1) {
            ASSERT_EQ(cpu_.data[reg], data[reg]) << "word " << std::hex << pc << " r" << std::dec << reg;
          }
        }
        ASSERT_EQ((cpu_.sreg() ^ flags) & e.flags_written, 0) << "word " << std::hex << pc;
        for (unsigned byte = 0; e.memory == InstructionEffects::Memory::store && byte < e.bytes; ++byte)
          ASSERT_EQ(cpu_.data[e.address + byte], data[e.address + byte]) << "word " << std::hex << pc;
      });
}

TEST_F(InstructionEffectsTest, SayHowTheProcessorContinues) {
  each_instruction([&](std::uint32_t pc, const Instruction& i, const State&, const InstructionEffects&) {
    const Control control = control_of(i.op);
    const std::uint32_t behind = pc + i.words, words = kAtmega2560.flash_bytes / 2;
    if (control == Control::returns || control == Control::indirect_jump || control == Control::indirect_call)
      return;
    const std::uint32_t target = target_of(i, pc, words);
    const bool has_target =
        control == Control::jump || control == Control::branch || control == Control::call;
    if (has_target && target >= words) return;  // JMP beyond the end of flash
    cpu_.run(cpu_.cycle() + 1);
    const bool goes_on = control != Control::jump && control != Control::call && cpu_.pc() == behind;
    const bool skips = control == Control::skip && cpu_.pc() == behind + cpu_.instruction(behind).words;
    ASSERT_TRUE(goes_on || skips || (has_target && cpu_.pc() == target))
        << "word " << std::hex << pc << " continues at " << cpu_.pc();
  });
}

}  // namespace instruction_effects_test
}  // namespace robosim::avr
