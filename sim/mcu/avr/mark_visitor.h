// Declares the visitor of marks, which is notified before a marked instruction runs (Cpu::set_mark).
#pragma once

#include <cstdint>

#include "sim/mcu/avr/cycle.h"

namespace robosim::avr {

class MarkVisitor {
 public:
  /// Visits the mark at word address `pc`. Returns whether the chip continues; otherwise Chip::run_to()
  /// returns.
  virtual bool visited(std::uint32_t pc, Cycle at) = 0;
  /// Reports the visits of the mark at `pc` by skipped passes of a waiting loop: `count` visits, the first at
  /// `first`, then one per `period`.
  virtual void left_out(std::uint32_t pc, Cycle first, Cycle period, std::uint64_t count) = 0;

 protected:
  ~MarkVisitor() = default;
};

}  // namespace robosim::avr
