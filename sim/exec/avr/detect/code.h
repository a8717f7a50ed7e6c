// What can be told of a sketch's instructions without running them. Addresses are words.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/avr/cpu.h"

namespace robosim::exec::avr {

/// Behind it runs the next instruction, whatever it does.
bool is_straight(robosim::avr::Op op);
bool is_store_by_pointer(robosim::avr::Op op);
/// Where the processor may go on behind the instruction at `pc`, as far as that stands in the code, is put
/// behind `next`; of a call, behind it, and with `into_calls` into it.
void add_next(const robosim::avr::Cpu& cpu, std::uint32_t pc, bool into_calls,
              std::vector<std::uint32_t>& next);
/// By word, up to `code_end` in bytes: whether interrupts are off there, as a CLI stands before it, with no
/// way in between.
std::vector<bool> without_interrupts(const robosim::avr::Cpu& cpu, std::uint32_t code_end);
/// By word: whether it is a handler's own, which the main program never runs; what handlers call is not.
std::vector<bool> of_handlers(const robosim::avr::Cpu& cpu, std::uint32_t code_end);

/// Where a value is that was read from memory, register by register: as it was read, or changed.
class Trail {
 public:
  explicit Trail(int reg) : read_(bit(reg)) {}
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
