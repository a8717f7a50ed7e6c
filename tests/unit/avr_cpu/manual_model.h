// A model of the processor. Its opcode patterns, Boolean formulas of flags, and cycles of AVRe and AVRe+ come
// only from the AVR Instruction Set Manual, DS40002198B. It is slow, and shares no code with sim/mcu/avr.
// Tests compare the processor of sim/mcu/avr with this model.
//
// All data memory is one array of 64 KB, which includes SREG, SP, RAMPZ and EIND. There are no peripherals
// and no interrupts.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace robosim::avr {

/// An instruction that a page of the manual describes. For "LDS Rd,k", `pattern` is "1001 000d dddd 0000",
/// and `words` is 2. The model has no rows for SPM and BREAK.
struct OpcodeRow {
  const char* name = nullptr;
  const char* pattern = nullptr;  ///< the first word's 16 digits and letters, as in the manual
  int words = 1;
};

class ManualModel {
 public:
  static constexpr std::uint16_t kRampz = 0x5B, kEind = 0x5C, kSp = 0x5D, kSreg = 0x5F;

  /// The number of words in `flash` is a power of two. If `long_pc` is true, the program counter has 22 bits.
  ManualModel(std::vector<std::uint16_t> flash, bool long_pc);

  /// Runs one instruction. Returns false, and does nothing, if the opcode is reserved, or the program counter
  /// is beyond flash.
  bool step();

  std::uint16_t sp() const { return word(kSp); }
  void set_sp(std::uint16_t value) { set_word(kSp, value); }

  std::array<std::uint8_t, 0x10000> data{};
  std::vector<std::uint16_t> flash;
  std::uint32_t pc = 0;  ///< in words
  std::uint64_t cycles = 0;

  /// Returns all rows. For each row, `ran` counts its executions. `jumped` counts the executions after which
  /// the program did not continue at the next word.
  static std::span<const OpcodeRow> rows();
  /// Returns the row of a word of flash, or nothing if the word is reserved.
  static std::optional<std::size_t> row_of(std::uint16_t word);
  std::vector<std::uint64_t> ran, jumped;

 private:
  struct Code;
  static const Code& code_of(std::size_t row);

  /// Returns the value of the opcode bits that the pattern marks with this letter.
  unsigned field(char letter) const;
  std::uint16_t word(std::uint16_t at) const {
    return static_cast<std::uint16_t>(data[at] | data[at + 1u] << 8);
  }
  void set_word(std::uint16_t at, unsigned value) {
    data[at] = static_cast<std::uint8_t>(value);
    data[at + 1u] = static_cast<std::uint8_t>(value >> 8);
  }
  bool flag(char name) const;
  void set_flag(char name, bool value);
  /// Sets S = N xor V.
  void set_sign() { set_flag('S', flag('N') != flag('V')); }
  void set_zero_and_negative(std::uint8_t result);

  std::uint8_t add(std::uint8_t d, std::uint8_t r, bool carry);
  std::uint8_t subtract(std::uint8_t d, std::uint8_t r, bool carry, bool keeps_zero);
  void logic(unsigned d, unsigned result);
  void shift(bool top);
  void multiply(int a, int b, bool fractional);
  void push(unsigned value);
  std::uint8_t pop();
  void call(std::uint32_t target);
  void return_from_call();
  void skip_if(bool condition);
  void branch_if(bool condition);
  std::uint8_t program_byte(std::uint32_t address) const;
  std::uint32_t relative(unsigned k, int bits) const;

  bool long_pc_;
  // State of the instruction that is being executed:
  std::uint16_t opcode_ = 0, second_ = 0;
  const char* pattern_ = nullptr;
};

}  // namespace robosim::avr
