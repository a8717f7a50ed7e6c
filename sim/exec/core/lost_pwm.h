// analogWrite() on a pin that no timer drives: it is LOW below 128, else HIGH.
//
//   const byte motors[] = {5, 7};   for (byte m : motors) analogWrite(m, speed);      7 knows no half speed
//
// Where the pin's number is a constant, the compiler's messages say so already (sim/build/pin_warnings.h);
// here it comes out of a variable. What is found is a call with a value between 1 and 254 on such a pin. 0
// and 255 do there what they say. Mended by wiring the part to a pin with PWM, or by SoftPWM.
//
// Two look for it: sim/exec/avr/detect/lost_pwm.h at the function's call on the chip, sim/judge/lost_pwm.h at
// the pin on the host.
#pragma once

#include <functional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

/// The calls that were found, one for each pin.
class LostPwmCalls {
 public:
  explicit LostPwmCalls(const BoardSpec& board) : board_(&board) {}

  /// Every call: those that lose nothing count for nothing. `where` is asked for the first of a pin.
  void add(Pin pin, int value, SimTime t, const std::function<SourceLine()>& where);
  std::vector<Detected> found() const { return found_; }

 private:
  const BoardSpec* board_;
  std::vector<Pin> pins_;        ///< of found_
  std::vector<Detected> found_;  ///< in the order of time
};

}  // namespace robosim::exec
