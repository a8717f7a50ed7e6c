// What a servo makes of its signal wire: the lengths of the pulses on it.
//
// A hobby servo takes the width of a pulse, some 0.5 to 2.5 ms, every 20 ms or so; how often does not matter
// to it. What is shorter than 0.3 ms or longer than 3 ms is no pulse. Pulses are told from changes of the
// pin's level: where a timer makes them (PWM), their length is not known here, and they are none.
#pragma once

#include <optional>

#include "hal/board/board.h"

namespace robosim::robot {

/// A value: what is known of the wire.
class ServoSignal {
 public:
  /// The wire is driven otherwise from `t` on: the length of the pulse that ends with that.
  std::optional<SimTime> change(const PinDrive& drive, SimTime t) {
    const bool high = drive.mode == PinMode::output && !drive.pwm && !drive.tone_hz && drive.level;
    const SimTime width = high_ && !high ? t - rose_ : 0;
    if (high && !high_) rose_ = t;
    high_ = high;
    if (width < 300 * kMicrosecond || width > 3 * kMillisecond) return std::nullopt;
    return width;
  }

 private:
  bool high_ = false;
  SimTime rose_ = 0;
};

}  // namespace robosim::robot
