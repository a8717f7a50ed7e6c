// One pass of a loop that waits, from its head back to it, as it was executed: what it read before it wrote
// it, which I/O registers it read, how long it took.
//
// Every pass is like this one as long as
//
//   - what it reads first is the same as at the head,
//   - I/O registers read the same, and
//   - the counter of a timer that it reads is within the window that CounterExtrapolation has found.
//
// A pass that writes I/O registers other than SREG, sleeps, or takes an interrupt cannot be skipped.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/avr/core.h"
#include "sim/avr/counter_extrapolation.h"
#include "sim/avr/instruction_effects.h"

namespace robosim::avr {

class LoopTrace {
 public:
  /// The preconditions and effects of one pass, except its computations.
  struct Pass {
    struct Byte {
      Address address = 0;
      std::uint8_t value = 0;
    };
    struct Look {
      Address address = 0;
      std::uint8_t value = 0;
      std::uint8_t bits = 0xFF;  ///< relevant ones
      bool counts = false;       ///< it is the counter: `value` may be larger by up to `window`
      Cycle after = 0;           ///< cycles since the head
    };
    std::vector<Byte> reads;  ///< registers and memory that it reads before writing them
    std::uint8_t flags_read = 0, flags = 0;
    std::uint16_t sp = 0;
    std::vector<Look> looks;
    int window = 0;  ///< of the counter
    Cycle cycles = 0;
    std::vector<std::uint32_t> jumps;  ///< calls and returns, as recorded by Cpu
    int visits = 0;                    ///< of marks
    std::uint32_t visited = 0;         ///< the place, and the time since the head
    Cycle visited_after = 0;
    bool enables_interrupts = false;
  };

  explicit LoopTrace(Core& core);

  /// Begins at the head.
  void begin();
  /// Called before one instruction runs. Returns whether it may belong to a pass that can be skipped.
  bool before();
  bool after();
  void visited(std::uint32_t pc);
  /// Called at the head again: returns whether the pass leads to its initial state. If so, sets `pass`.
  bool ends(Pass& pass);

 private:
  bool touches_memory();
  bool looks_at(Address address);
  void reads(Address address);
  void writes(Address address);
  void reads_flags(std::uint8_t flags);

  Core& core_;
  CounterExtrapolation extrapolation_;
  Pass pass_;
  std::vector<std::uint32_t> seen_;  ///< by address: the last pass with an access
  std::uint32_t number_ = 0;
  std::uint8_t flags_written_ = 0;
  Cycle began_ = 0;
  std::uint32_t jumps_before_ = 0;
  int steps_ = 0;
  Instruction instruction_;
  InstructionEffects effects_;
  std::optional<std::uint8_t> looked_;  ///< expected value of an I/O register
  bool counter_ = false;                ///< whether that register is the counter
};

}  // namespace robosim::avr
