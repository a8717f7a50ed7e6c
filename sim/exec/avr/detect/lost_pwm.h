// Detects analogWrite() on a pin without PWM, on the chip (sim/exec/core/lost_pwm.h). When the function
// starts, its arguments are in registers (avr-gcc's ABI: the pin in R24, the value in R22 and R23). Not
// detected: inlined calls, such as the only call in a sketch.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/machine.h"
#include "sim/exec/core/lost_pwm.h"

namespace robosim::exec::avr {

class LostPwm final : public Detector {
 public:
  LostPwm(Machine& machine, const Program& program);

  void visited(std::uint32_t pc, robosim::avr::Cycle at) override;
  std::vector<Detected> found() const override { return calls_.found(); }

 private:
  const Machine& machine_;
  const DebugInfo& debug_;
  LostPwmCalls calls_;
};

}  // namespace robosim::exec::avr
