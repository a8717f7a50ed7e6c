// Analyses a sketch's instructions statically. Addresses are in words.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/mcu/avr/cpu.h"

namespace robosim::exec::avr {

/// Appends to `next` the addresses at which the processor may continue after the instruction at `pc`.
/// Computed jumps are not followed. A call continues at the following instruction, and with `into_calls` also
/// at its target.
void add_next(const robosim::avr::Cpu& cpu, std::uint32_t pc, bool into_calls,
              std::vector<std::uint32_t>& next);
/// Returns, for each word of flash, whether interrupts are certainly off there. This is so in straight-line
/// code after a CLI. `code_end` is a byte address.
std::vector<bool> without_interrupts(const robosim::avr::Cpu& cpu, std::uint32_t code_end);
/// Returns, for each word of flash, whether the word belongs to an interrupt handler. The main program never
/// runs these words. Functions that handlers call are not included.
std::vector<bool> of_handlers(const robosim::avr::Cpu& cpu, std::uint32_t code_end);

/// Tracks which registers contain a certain value that was read from memory, or a value computed from it.
class ValueFlow {
 public:
  explicit ValueFlow(int reg) : read_(bit(reg)) {}
  bool is_changed(int reg) const { return (changed_ & bit(reg)) != 0; }
  void follow(const robosim::avr::Instruction& i);

 private:
  static std::uint32_t bit(int reg) { return std::uint32_t{1} << (reg & 31); }
  bool has(int reg) const { return ((read_ | changed_) & bit(reg)) != 0; }
  void drop(int reg) { read_ &= ~bit(reg), changed_ &= ~bit(reg); }
  void change(int reg) { read_ &= ~bit(reg), changed_ |= bit(reg); }
  void copy(int to, int from) {
    const bool was_read = (read_ & bit(from)) != 0, was_changed = is_changed(from);
    drop(to);
    if (was_read) read_ |= bit(to);
    if (was_changed) changed_ |= bit(to);
  }

  std::uint32_t read_, changed_ = 0;
};

}  // namespace robosim::exec::avr
