// Detects analogWrite() on a pin that no timer drives: the pin is LOW below 128, else HIGH.
//   const byte motors[] = {5, 7};   for (byte m : motors) analogWrite(m, speed);      pin 7 has no PWM
//
// If the pin's number is a constant, the compiler's messages report it already (sim/build/pin_warnings.h).
// Here the number comes from a variable. A finding is a call with a value from 1 to 254 on such a pin; 0 and
// 255 work there as intended. Fix it by wiring the part to a pin with PWM, or by SoftPWM.
//
// Two detectors feed it: sim/exec/avr/detect/lost_pwm.h at the function's call on the chip, and
// sim/judge/lost_pwm.h at the pin on the host.
#pragma once

#include <functional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

/// Collects the calls that were found, one for each pin.
class LostPwmCalls {
 public:
  explicit LostPwmCalls(const BoardSpec& board) : board_(&board) {}

  /// Adds a call; calls that lose nothing are ignored. `where` is called for the first finding of a pin.
  void add(Pin pin, int value, SimTime t, const std::function<SourceLine()>& where);
  std::vector<Detected> found() const { return found_; }

 private:
  const BoardSpec* board_;
  std::vector<Pin> pins_;        ///< of found_
  std::vector<Detected> found_;  ///< by time
};

}  // namespace robosim::exec
