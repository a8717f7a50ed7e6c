// Observes the stack: its depth, its overflow into the variables, and the calls that have not returned.
//
//   0x0100 variables | heap -> ...        ... <- stack | 0x08FF      addresses of an ATmega328P
//
// The chip checks every change of the stack pointer. It therefore detects even an overflow by a call that
// returns soon, or by an array that is never written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/exec/avr/watched_chip.h"

namespace robosim::exec::avr {

class Stack {
 public:
  Stack(WatchedChip& chip, const Firmware& firmware);

  bool has_heap() const { return heap_pointer_ != 0; }
  /// Raises the stack's limit to the end of the heap, if the heap has grown.
  void look();
  /// Returns the largest number of bytes that the stack has used.
  std::uint32_t most_bytes() const {
    return firmware_.last_ram - static_cast<std::uint32_t>(chip_.lowest_sp());
  }
  /// Returns the number of bytes from the end of the variables and the heap to the end of RAM.
  std::uint32_t room_bytes() const { return firmware_.last_ram + 1u - state_.heap_end; }
  /// Returns the number of bytes that the variables, the heap and the stack have never used.
  std::uint32_t least_free_bytes() const { return room_bytes() - std::min(room_bytes(), most_bytes()); }
  /// Returns whether the stack has reached the variables or the heap.
  bool has_overflown() const { return chip_.lowest_sp() + 1 < state_.heap_end; }

  /// A call instruction whose callee has not returned yet.
  struct Call {
    std::uint32_t pc = 0;     ///< address of the call instruction
    bool by_pointer = false;  ///< the instruction is icall or eicall
  };
  /// Returns the calls that have not returned, innermost first. Every word on the stack that is the address
  /// after a call instruction counts as such a call. Saved registers may look like such an address by chance.
  std::vector<Call> open_calls() const;
  /// Passes each call that has not returned to `visit`, until `visit` returns true. Also stops at the return
  /// address `until`; 0 = no such address.
  template <typename Visit>
  void each_call(std::uint32_t until, Visit visit) const {
    Call call;
    const std::uint32_t bytes = firmware_.chip->return_address_bytes;
    for (std::uint32_t at = chip_.sp() + 1u; at + bytes - 1u <= firmware_.last_ram; ++at) {
      if (at < firmware_.chip->ram_address) continue;
      const std::uint32_t word = return_address(at);
      if (until != 0 && word == until) return;
      if (!find_call(word, call)) continue;
      if (visit(call)) return;
      at += bytes - 1u;
    }
  }
  struct State {
    std::uint16_t heap_end = 0;  ///< highest end of the heap so far
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

  /// Returns the return address that the last `ret` has popped, as a flash address in bytes.
  std::uint32_t last_return() const;

 private:
  std::uint32_t return_address(std::uint32_t at) const;
  bool find_call(std::uint32_t return_pc, Call& call) const;

  WatchedChip& chip_;
  const Firmware& firmware_;
  const std::uint16_t heap_pointer_;  ///< address at which malloc stores the heap's end; 0 = no heap
  State state_;
};

}  // namespace robosim::exec::avr
