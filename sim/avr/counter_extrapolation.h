// Follows the values that a loop computes from a counter, while one pass of it runs: for how many counts more
// will all its jumps go the same way?
//
//   the counter reads v0 now, v0 + n later
//   Line    a whole number that is `now` at n = 0, and `now` + n * `step` in general
//   Byte    byte k of a Line, in two's complement: what a register of the processor holds of it
//   Chain   the flags of a sum or difference of two Lines that is made byte by byte: ADD ADC ADC, CP CPC …
//
// Sums and differences of Bytes are followed as long as the bytes belong together. Any other use of a Byte
// holds it: the window, the range of n, shrinks to those at which the byte has its present value. So nothing
// is guessed; in the worst case the window is this one count.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sim/avr/cpu.h"
#include "sim/avr/instruction_effects.h"

namespace robosim::avr {

class CounterExtrapolation {
 public:
  explicit CounterExtrapolation(const Cpu& cpu) : cpu_(cpu) {}

  /// Begins: nothing depends on the counter yet.
  void begin();
  /// Follows an instruction with these effects, which is about to run.
  void follow(const Instruction& instruction, const InstructionEffects& effects);
  /// Notes that it has read the counter into this register, which holds v0 now.
  void counter_read(unsigned reg);
  bool has_counter() const { return has_counter_; }
  /// Returns whether these registers, one bit each, match the Lines. If not, this file is wrong.
  bool agrees(std::uint32_t registers) const;

  /// Requires that this memory, and these flags, keep their present values.
  void hold(Address address);
  void hold_flags(unsigned flags);

  /// Returns the largest n for which everything is as at n = 0.
  std::int64_t window() const { return window_; }

 private:
  struct Line {
    std::int64_t now = 0, step = 0;
  };
  struct Byte {
    Line line;
    int k = 0;
  };
  using Operand = std::optional<Byte>;  ///< none = equal for all n
  struct Chain {
    bool subtracts = false;
    bool whole = false;  ///< Z covers all bytes, down to byte 0
    Line left, right, result;
    int k = 0;  ///< the last computed byte
  };

  void keep(const Line& line, int bits);
  void hold(Operand& operand);
  void hold_registers(std::uint32_t registers);
  void hold_all_flags();
  void hold_zero();

  void add_or_subtract(const Instruction& instruction);
  std::optional<Chain> chained(const Instruction& instruction, const Operand& right, std::uint8_t constant);
  std::optional<Chain> begun(const Instruction& instruction, const Operand& right, std::uint8_t constant);
  void add_word(const Instruction& instruction);
  void load(const Instruction& instruction, const InstructionEffects& effects);
  void store(const Instruction& instruction, const InstructionEffects& effects);
  void compute(const InstructionEffects& effects);
  std::optional<Line> extended(const Line& line, const Operand& byte, std::uint8_t constant, int k);
  Operand* find(Address address);

  const Cpu& cpu_;
  bool has_counter_ = false;
  std::array<Operand, 32> registers_;
  std::vector<std::pair<Address, Operand>> memory_;  ///< stored values of the pass
  std::optional<Chain> chain_;                       ///< none = the flags are equal for all n
  std::int64_t window_ = 0;
};

}  // namespace robosim::avr
