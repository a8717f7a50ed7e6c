// Finds analogWrite() on a pin without PWM, on the host (sim/exec/core/lost_pwm.h). Examines the call in
// progress and its arguments when the pin's level changes. Calls that do not change the level, such as most
// calls with a value below 128, are not detected. Only the first changes of a pin are examined, since some
// pins carry many pulses.
#pragma once

#include <vector>

#include "sim/exec/core/lost_pwm.h"

namespace robosim::judge {

class LostPwm {
 public:
  explicit LostPwm(const BoardSpec& board) : board_(&board), asked_(board.pin_count), calls_(board) {}

  /// Handles a change of any pin while `executor` runs.
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t, exec::Executor& executor);
  std::vector<exec::Detected> found() const { return calls_.found(); }

 private:
  const BoardSpec* board_;
  std::vector<int> asked_;  ///< number of examined changes, by pin
  exec::LostPwmCalls calls_;
};

}  // namespace robosim::judge
