// Is notified before an instruction with a mark runs (Cpu::set_mark).
#pragma once

#include <cstdint>

#include "sim/avr/cycle.h"

namespace robosim::avr {

class Visitor {
 public:
  /// Returns whether the chip runs on; otherwise Chip::run_to() comes back. `pc` in words.
  virtual bool visited(std::uint32_t pc, Cycle at) = 0;
  /// It ran on at `pc` in a loop that waits, passes of which were left out: visits at `first` and then every
  /// `period`, `count` in all.
  virtual void left_out(std::uint32_t pc, Cycle first, Cycle period, std::uint64_t count) = 0;

 protected:
  ~Visitor() = default;
};

}  // namespace robosim::avr
