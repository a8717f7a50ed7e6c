// Decides when the visible text of a part, such as a display, is reported.
#pragma once

#include <string>

#include "hal/board/sim_time.h"

namespace robosim::robot {

/// Reports a text once it has stayed the same for 50 ms. The class is a copyable value.
class SettledText {
 public:
  /// Returns whether poll_text() is due at `t` for a text that last changed at `changed`.
  bool is_due(SimTime changed, SimTime t) const { return changed != told_at_ && t - changed >= kSettles; }
  /// Returns the text to report; "" = none. An empty text is reported as a space.
  std::string poll_text(SimTime changed, const std::string& text) {
    told_at_ = changed;
    if (text == told_) return {};
    told_ = text;
    return text.empty() ? " " : text;
  }

 private:
  static constexpr SimTime kSettles = 50 * kMillisecond;

  SimTime told_at_ = -1;
  std::string told_;
};

}  // namespace robosim::robot
