// analogWrite() on a pin that no timer drives: it is LOW below 128, else HIGH.
//
//   const byte motors[] = {5, 7};   for (byte m : motors) analogWrite(m, speed);      7 knows no half speed
//
// Where the pin's number is a constant, the compiler's messages say so already (sim/build/pin_warnings.h);
// here it comes out of a variable. What is found is a call with a value between 1 and 254 on such a pin. 0
// and 255 do there what they say. Mended by wiring the part to a pin with PWM, or by SoftPWM.
//
// On the chip the function's arguments lie in registers when it begins (avr-gcc's ABI: the pin in R24, the
// value in R22 and R23). Not seen are calls that the compiler has put in place of the function.
#pragma once

#include <cstdint>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/avr/detector.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

class LostPwm final : public Detector {
 public:
  LostPwm(Machine& machine, const Program& program);

  void visited(std::uint32_t pc, robosim::avr::Cycle at) override;
  std::vector<Detected> found() const override;

 private:
  struct Call {
    Pin pin = kNoPin;
    int value = 0;   ///< the first time
    SimTime at = 0;  ///< then
    std::uint32_t pc = 0;
    std::int64_t times = 0;
  };

  const Machine& machine_;
  const DebugInfo& debug_;
  const BoardSpec& board_;
  std::vector<Call> calls_;  ///< one for each pin, in the order of time
};

}  // namespace robosim::exec::avr
