// Finds the line of the sketch that has driven a pin, while the chip reports the change.
//
//   an instruction writes to I/O      its line, or that of the call which led there
//   a timer starts a new duty cycle   at the end of a period, so the line is the one that has written OCRnx
//   a timer or handler of the core    switches the pin by itself: no line
#pragma once

#include <vector>

#include "sim/exec/avr/stack.h"
#include "sim/exec/avr/watched_chip.h"
#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class DrivenLines {
 public:
  /// All three outlive this, which outlives the chip's use.
  DrivenLines(WatchedChip& chip, const Stack& stack, const DebugInfo& debug);
  DrivenLines(const DrivenLines&) = delete;
  DrivenLines& operator=(const DrivenLines&) = delete;

  /// Returns the line. `pin`: the chip's; `pwm`: PWM drives it from now on. Empty if no line is known.
  const SourceLine& line_of(int pin, bool pwm) const;

 private:
  using Address = reg::Address;
  void will_write(Address address);
  const SourceLine& line_now() const;

  WatchedChip& chip_;
  const Stack& stack_;
  const DebugInfo& debug_;
  Cycle written_at_ = robosim::avr::kNoCycle;
  std::vector<int> pin_of_compare_;             ///< by address of OCRnx; -1 = none
  std::vector<const SourceLine*> compared_by_;  ///< by the chip's pin; null = not yet
};

}  // namespace robosim::exec::avr
