// Declares the interface of objects that observe a running chip without changing the run.
#pragma once

#include <cstdint>

#include "sim/mcu/avr/cycle.h"

namespace robosim::exec::avr {

class ChipObserver {
 public:
  /// Called before the instruction at byte address `pc` runs, if WatchedChip::show() has requested this
  /// address.
  virtual void visited(std::uint32_t pc, robosim::avr::Cycle at) {
    static_cast<void>(pc), static_cast<void>(at);
  }
  /// Called when the processor has entered or left a handler (WatchedChip::show_handlers()).
  virtual void entered(int vector, robosim::avr::Cycle at) {
    static_cast<void>(vector), static_cast<void>(at);
  }
  virtual void left() {}

 protected:
  ~ChipObserver() = default;
};

}  // namespace robosim::exec::avr
