// Finds the line of the sketch that has driven a pin. Call line_of() only while the chip reports the pin's
// change. The core is the Arduino core.
//
//   cause of the change               line
//   an instruction writes to I/O      line of the instruction; for an instruction of the core, line of the
//                                     innermost call in user code
//   a timer starts a new duty cycle   line that wrote OCRnx, although the pin changes at the end of a period
//   a timer, a handler of the core    no line, because the timer or handler switches the pin by itself
#pragma once

#include <vector>

#include "sim/exec/avr/stack.h"
#include "sim/exec/avr/watched_chip.h"
#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class DrivenLines {
 public:
  /// All arguments must outlive this object. This object must exist as long as the chip runs.
  DrivenLines(WatchedChip& chip, const Stack& stack, const DebugInfo& debug);
  DrivenLines(const DrivenLines&) = delete;
  DrivenLines& operator=(const DrivenLines&) = delete;

  /// Returns the line that has driven the chip's `pin`; empty if the line is unknown. `pwm` is true if PWM
  /// drives the pin from now on.
  const SourceLine& line_of(int pin, bool pwm) const;

 private:
  using Address = reg::Address;
  void will_write(Address address);
  const SourceLine& line_now() const;

  WatchedChip& chip_;
  const Stack& stack_;
  const DebugInfo& debug_;
  Cycle written_at_ = robosim::avr::kNoCycle;
  std::vector<int> pin_of_compare_;             ///< the chip's pin, by the address of OCRnx; -1 = no pin
  std::vector<const SourceLine*> compared_by_;  ///< last line that wrote OCRnx, by the chip's pin; or null
};

}  // namespace robosim::exec::avr
