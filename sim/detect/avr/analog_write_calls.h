// Observes the calls of analogWrite() on an AVR, and adds them to LostPwmCalls (lost_pwm.h). When the
// function starts, the pin is in R24 and the value is in R22 and R23 (avr-gcc's ABI). Inlined calls are not
// detected. For example, the compiler may inline the only call in a sketch.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/detect/avr/chip_detector.h"
#include "sim/detect/lost_pwm.h"

namespace robosim::detect::avr {

class AnalogWriteCalls final : public ChipDetector {
 public:
  explicit AnalogWriteCalls(const RunningProgram& program);

  void visited(std::uint32_t pc, Cycle at) override;
  std::vector<Detected> found(SimTime) const override { return calls_.found(); }

 private:
  const RunningProgram program_;
  LostPwmCalls calls_;
};

}  // namespace robosim::detect::avr
