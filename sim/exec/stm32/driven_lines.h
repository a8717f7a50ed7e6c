// Finds the line of the sketch that drives a pin. Call line_of() only while the chip reports the pin's
// change.
//
//   cause                                  line
//   an instruction writes to a register    line of the instruction. In the Arduino core, line of the last
//                                          jump from user code, or else of the innermost user call
//   a timer applies a new duty cycle       the line that last wrote TIMx_CCRy before the timer's update
//   a timer or a handler of the core       none
#pragma once

#include <map>

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/stm32/machine.h"

namespace robosim::exec::stm32 {

class DrivenLines {
 public:
  /// This object must exist as long as the chip runs. `machine` and `debug` must outlive this object.
  DrivenLines(Machine& machine, const DebugInfo& debug);
  DrivenLines(const DrivenLines&) = delete;
  DrivenLines& operator=(const DrivenLines&) = delete;

  /// Returns the line that drives the pin; empty if the line is unknown. `pwm` is true if PWM drives the pin
  /// from now on.
  const SourceLine& line_of(const PinSpec& pin, bool pwm) const;

 private:
  void will_store(Address address);
  const SourceLine& line_now() const;

  const Machine& machine_;
  const DebugInfo& debug_;
  /// The last line that wrote each TIMx_CCRy, by the register's address; null = not written yet.
  std::map<Address, const SourceLine*> compared_by_;
};

}  // namespace robosim::exec::stm32
