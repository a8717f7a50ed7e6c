// The stack: how deep it has been, whether it has met the variables, and who called whom.
//
// At power-on the RAM behind the variables is painted. What has lost its paint, from the top of the RAM down
// to the lowest such byte above the heap, has been stack. An interrupt's or a call's few bytes count as any
// others; a local array that is never written to leaves its paint, so what lies below it may be missed.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/executors/avr/chip.h"

namespace robosim::executors::avr {

class Stack {
 public:
  Stack(Chip& chip, const Firmware& firmware);

  /// A look at the stack pointer and at the border to the heap; fails the chip if the stack has crossed it.
  void look();
  /// The most bytes that were in use, 0 before anything ran.
  std::uint32_t most_bytes() const;
  /// Whether the stack has reached the variables or the heap.
  bool has_overflown() const;

  /// An instruction in the code that called something.
  struct Call {
    std::uint32_t pc = 0;     ///< of the call instruction
    bool by_pointer = false;  ///< icall
  };
  /// The calls that are open now, innermost first: every word on the stack that is the address behind a call.
  /// Saved registers may look like one by chance.
  std::vector<Call> open_calls() const;
  /// Calls that have returned lately and whose words are still there, the last first.
  std::vector<Call> past_calls() const;
  /// The word that the last `ret` has taken, as a flash address.
  std::uint32_t last_return() const;

 private:
  std::uint32_t return_address(std::uint32_t at) const;
  bool find_call(std::uint32_t return_pc, Call& call) const;
  std::uint16_t lowest() const { return heap_end_; }

  Chip& chip_;
  const Firmware& firmware_;
  std::uint16_t heap_pointer_ = 0;  ///< where malloc keeps the heap's end; 0 = there is no heap
  std::uint16_t heap_end_;          ///< the highest it has been
};

}  // namespace robosim::executors::avr
