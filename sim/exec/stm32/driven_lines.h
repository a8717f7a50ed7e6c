// Finds the line of the sketch that has driven a pin, asked while the chip reports the change.
//
//   cause                                  line
//   an instruction writes to a register    its own, or that of the jump that led out of the sketch
//   a timer takes over a new duty cycle    the one that wrote TIMx_CCRy before the timer's update
//   a timer or handler of the core         none
#pragma once

#include <map>

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/stm32/machine.h"

namespace robosim::exec::stm32 {

class DrivenLines {
 public:
  /// Both outlive this, which outlives the chip's use.
  DrivenLines(Machine& machine, const DebugInfo& debug);
  DrivenLines(const DrivenLines&) = delete;
  DrivenLines& operator=(const DrivenLines&) = delete;

  /// Returns the line. `pwm`: PWM drives the pin from now on. Empty if no line is known.
  const SourceLine& line_of(const PinSpec& pin, bool pwm) const;

 private:
  void will_store(Address address);
  const SourceLine& line_now() const;

  const Machine& machine_;
  const DebugInfo& debug_;
  std::map<Address, const SourceLine*> compared_by_;  ///< by address of TIMx_CCRy; null = not yet
};

}  // namespace robosim::exec::stm32
