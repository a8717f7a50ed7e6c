// One pass of a loop that waits, from its head back to it, as it was executed: what it read before it wrote
// it, which I/O registers it read, how long it took.
//
// Every pass is like this one as long as
//
//   - what it reads first is the same as at the head,
//   - I/O registers read the same, and
//   - the counter of a timer that it reads is within the window that Ramp has found.
//
// A pass that writes I/O registers other than SREG, sleeps, or takes an interrupt cannot be skipped.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/avr/core.h"
#include "sim/avr/effects.h"
#include "sim/avr/ramp.h"

namespace robosim::avr {

class Path {
 public:
  /// What one pass needs, and does, besides what it computes.
  struct Pass {
    struct Byte {
      Address address = 0;
      std::uint8_t value = 0;
    };
    struct Look {
      Address address = 0;
      std::uint8_t value = 0;
      std::uint8_t bits = 0xFF;  ///< it looks at no others
      bool counts = false;       ///< it is the counter: `value` may be up to `window` more
      Cycle after = 0;           ///< the head, in cycles
    };
    std::vector<Byte> reads;  ///< registers and memory that it reads before it writes them
    std::uint8_t flags_read = 0, flags = 0;
    std::uint16_t sp = 0;
    std::vector<Look> looks;
    int window = 0;  ///< of the counter
    Cycle cycles = 0;
    std::vector<std::uint32_t> jumps;  ///< calls and returns, as Cpu notes them
    int visits = 0;                    ///< of marks
    std::uint32_t visited = 0;         ///< the place, and when, from the head on
    Cycle visited_after = 0;
    bool enables_interrupts = false;
  };

  explicit Path(Core& core);

  /// The processor is at the head.
  void begin();
  /// It is about to run one instruction. Returns whether that may belong to a pass that can be left out.
  bool before();
  bool after();
  void visited(std::uint32_t pc);
  /// It is at the head again: whether the pass leads to where it began. If so, `pass` is what it was.
  bool ends(Pass& pass);

 private:
  bool touches_memory();
  bool looks_at(Address address);
  void reads(Address address);
  void writes(Address address);
  void reads_flags(std::uint8_t flags);

  Core& core_;
  Ramp ramp_;
  Pass pass_;
  std::vector<std::uint32_t> seen_;  ///< by address: the last pass that touched it
  std::uint32_t number_ = 0;
  std::uint8_t flags_written_ = 0;
  Cycle began_ = 0;
  std::uint32_t jumps_before_ = 0;
  int steps_ = 0;
  Instruction instruction_;
  Effects effects_;
  std::optional<std::uint8_t> looked_;  ///< what a register of I/O is to give
  bool counter_ = false;                ///< which is the counter
};

}  // namespace robosim::avr
