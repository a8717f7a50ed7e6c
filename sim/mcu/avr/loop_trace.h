// Records one executed pass of a waiting loop, from the loop's head back to the head: inputs, reads of I/O
// registers, and duration. Inputs are registers and memory that the pass reads before it writes them.
//
// Further passes equal the recorded pass as long as
//
//   - the inputs have the same values as at the head,
//   - I/O registers read the same values, and
//   - the timer counter that the pass reads is within the window that CounterExtrapolation has found.
//
// A pass that writes I/O registers other than SREG, sleeps, or is interrupted cannot be skipped.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/mcu/avr/core.h"
#include "sim/mcu/avr/counter_extrapolation.h"
#include "sim/mcu/avr/instruction_effects.h"

namespace robosim::avr {

class LoopTrace {
 public:
  /// The preconditions of one pass, and its effects on time, calls and marks. Excludes the values that the
  /// pass computes.
  struct Pass {
    struct Byte {
      Address address = 0;
      std::uint8_t value = 0;
    };
    struct Look {
      Address address = 0;
      std::uint8_t value = 0;
      std::uint8_t bits = 0xFF;  ///< relevant bits
      bool counts = false;       ///< a timer's counter: a read may exceed `value` by up to `window`
      Cycle after = 0;           ///< cycles from the head to the read
    };
    std::vector<Byte> reads;  ///< inputs: registers and memory
    std::uint8_t flags_read = 0, flags = 0;
    std::uint16_t sp = 0;
    std::vector<Look> looks;
    int window = 0;  ///< window of the counter
    Cycle cycles = 0;
    std::vector<std::uint32_t> jumps;  ///< calls and returns, as recorded by Cpu
    int visits = 0;                    ///< number of visited marks
    std::uint32_t visited = 0;         ///< word address of the visited mark
    Cycle visited_after = 0;
    bool enables_interrupts = false;
  };

  explicit LoopTrace(Core& core);

  /// Starts recording at the head.
  void begin();
  /// Records an instruction before it runs. Returns whether the instruction can belong to a pass that can be
  /// skipped.
  bool before();
  bool after();
  void visited(std::uint32_t pc);
  /// Ends the pass at the head. If the pass leads back to its initial state, sets `pass` and returns true.
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
  std::vector<std::uint32_t> seen_;  ///< by address: number of the last pass that accessed the address
  std::uint32_t number_ = 0;
  std::uint8_t flags_written_ = 0;
  Cycle began_ = 0;
  std::uint32_t jumps_before_ = 0;
  int steps_ = 0;
  Instruction instruction_;
  InstructionEffects effects_;
  std::optional<std::uint8_t> looked_;  ///< expected value of the I/O register that the instruction reads
  bool counter_ = false;                ///< the I/O register is the counter
};

}  // namespace robosim::avr
