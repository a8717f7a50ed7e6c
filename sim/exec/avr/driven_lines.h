// Which line of the sketch has driven a pin, asked while the chip tells that it is driven.
//
//   an instruction writes to I/O    it has driven the pin: its line, or that of the call which led there
//   a timer takes a new duty over   at the end of a period, so it is the line that has written OCRnx
//   a timer or handler of the core  switches the pin by itself: no line has
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

  /// `pin`: the chip's; `pwm`: it is driven by PWM from now on. Empty where no line is known.
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
