// Finds analogWrite() on a pin without PWM, on the host (sim/exec/core/lost_pwm.h). When the pin's level
// changes, the call in progress is known with its arguments. Calls that do not change the level, as most with
// a value below 128, are not detected. Only the first changes of a pin are examined, since some pins carry
// many pulses.
#pragma once

#include <vector>

#include "sim/exec/core/lost_pwm.h"

namespace robosim::judge {

class LostPwm {
 public:
  explicit LostPwm(const BoardSpec& board) : board_(&board), asked_(board.pin_count), calls_(board) {}

  /// Handles changes of every pin, while `executor` runs.
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t, exec::Executor& executor);
  std::vector<exec::Detected> found() const { return calls_.found(); }

 private:
  const BoardSpec* board_;
  std::vector<int> asked_;  ///< by pin: number of examined changes
  exec::LostPwmCalls calls_;
};

}  // namespace robosim::judge
