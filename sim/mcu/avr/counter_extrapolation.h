// Analyses one pass of a loop that reads a timer's counter. Tracks the values that the pass computes from the
// counter. Determines how far the counter can advance before a jump in the pass leads to another target.
//
//   n       number of counts by which a later pass is ahead: this pass reads v0, the later pass v0 + n
//   Line    an integer that is linear in n: `now` + n * `step`
//   Byte    byte k of a Line in two's complement, as a processor register stores it
//   Chain   the flags of a sum or difference of two Lines, computed byte by byte: ADD ADC ADC, CP CPC …
//
// Sums and differences of Bytes are tracked as long as their bytes belong to the same number. Any other use
// of a Byte "holds" it: the result is valid only while this byte does not change. Holding a byte shrinks the
// window, which is the range of n from 0 to window(). The window is never too large. In the worst case, it
// contains only n = 0.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sim/mcu/avr/cpu.h"
#include "sim/mcu/avr/instruction_effects.h"

namespace robosim::avr {

class CounterExtrapolation {
 public:
  explicit CounterExtrapolation(const Cpu& cpu) : cpu_(cpu) {}

  /// Begins a pass. So far, nothing depends on the counter.
  void begin();
  /// Tracks an instruction that is about to run with these effects.
  void follow(const Instruction& instruction, const InstructionEffects& effects);
  /// Notes that the loop has read the counter into this register, which now contains v0.
  void counter_read(unsigned reg);
  bool has_counter() const { return has_counter_; }
  /// Returns whether these registers, one bit each, match their Lines. A mismatch is a bug in this class.
  bool agrees(std::uint32_t registers) const;

  /// Shrink the window until the byte at `address`, or each of `flags`, is constant within the window.
  void hold(Address address);
  void hold_flags(unsigned flags);

  /// Returns the largest n for which all held values equal their values at n = 0.
  std::int64_t window() const { return window_; }

 private:
  struct Line {
    std::int64_t now = 0, step = 0;
  };
  struct Byte {
    Line line;
    int k = 0;
  };
  using Operand = std::optional<Byte>;  ///< empty = equal for all n
  struct Chain {
    bool subtracts = false;
    bool whole = false;  ///< flag Z covers all bytes from byte 0 to byte k
    Line left, right, result;
    int k = 0;  ///< index of the last computed byte
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
  std::vector<std::pair<Address, Operand>> memory_;  ///< values that the pass has stored
  std::optional<Chain> chain_;                       ///< empty = the flags are equal for all n
  std::int64_t window_ = 0;
};

}  // namespace robosim::avr
