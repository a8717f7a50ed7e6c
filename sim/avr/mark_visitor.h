// Is notified before an instruction with a mark runs (Cpu::set_mark).
#pragma once

#include <cstdint>

#include "sim/avr/cycle.h"

namespace robosim::avr {

class MarkVisitor {
 public:
  /// Returns whether the chip continues; otherwise Chip::run_to() returns. `pc` in words.
  virtual bool visited(std::uint32_t pc, Cycle at) = 0;
  /// Reports skipped passes of a waiting loop at `pc`: visits at `first` and then every `period`, `count` in
  /// all.
  virtual void left_out(std::uint32_t pc, Cycle first, Cycle period, std::uint64_t count) = 0;

 protected:
  ~MarkVisitor() = default;
};

}  // namespace robosim::avr
