// Collects calls of analogWrite() on the chip in LostPwmCalls. When the function starts, its arguments are in
// registers (avr-gcc's ABI: the pin in R24, the value in R22 and R23). Not detected: inlined calls, such as
// the only call in a sketch.
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
