// Decides when to check whether firmware that makes no calls will ever call the API again. The check is slow.
#pragma once

#include "hal/board/sim_time.h"

namespace robosim::exec {

class HangProbeBackoff {
 public:
  static constexpr SimTime kFirstLook = kSecond;

  /// Returns whether to check now. Checks are due 1, 2, 4, … s after the last call of the API.
  bool is_time(SimTime last_call, SimTime now) {
    if (last_call != since_) {
      since_ = last_call;
      next_ = last_call + kFirstLook;
    }
    if (now < next_) return false;
    next_ = now + (now - since_);
    return true;
  }
  bool lasts_since(SimTime last_call) const { return last_call == since_; }

 private:
  SimTime since_ = -1, next_ = 0;
};

}  // namespace robosim::exec
