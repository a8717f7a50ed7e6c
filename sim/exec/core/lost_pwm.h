// Detects analogWrite() on a pin that no timer drives. Such a pin is LOW for values below 128, else HIGH.
//   const byte motors[] = {5, 7};   for (byte m : motors) analogWrite(m, speed);      pin 7 has no PWM
//
// If the pin's number is a constant, the compiler already reports the call (sim/build/pin_warnings.h). This
// detector covers pin numbers from variables. A finding is a call with a value from 1 to 254; 0 and 255 work
// as intended. To fix the sketch, wire the part to a pin with PWM, or use SoftPWM.
//
// Two detectors use this class: sim/exec/avr/detect/lost_pwm.h detects the function's call on the chip, and
// sim/judge/lost_pwm.h detects the pin's level on the host.
#pragma once

#include <functional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

/// Collects the calls found, one for each pin.
class LostPwmCalls {
 public:
  explicit LostPwmCalls(const BoardSpec& board) : board_(&board) {}

  /// Adds a call, unless its value has the intended effect. `where` is called for the first finding of a pin.
  void add(Pin pin, int value, SimTime t, const std::function<SourceLine()>& where);
  std::vector<Detected> found() const { return found_; }

 private:
  const BoardSpec* board_;
  std::vector<Pin> pins_;        ///< pins of found_
  std::vector<Detected> found_;  ///< sorted by time
};

}  // namespace robosim::exec
