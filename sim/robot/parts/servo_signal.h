// What a servo makes of its signal wire: the lengths of the pulses on it.
//
// A hobby servo takes the width of a pulse, some 0.5 to 2.5 ms, every 20 ms or so; how often does not matter
// to it. What is shorter than 0.3 ms or longer than 3 ms is no pulse. Pulses are told from changes of the
// pin's level; where a timer or a PWM driver makes them, from duty and period: each is as long from the
// change on, without waiting for the period that runs. PWM of which no period is known makes none.
#pragma once

#include <optional>

#include "hal/board/board.h"

namespace robosim::robot {

/// A value: what is known of the wire.
class ServoSignal {
 public:
  /// The wire is driven otherwise from `t` on: the length of the pulse that ends with that, or of those that
  /// come from now on.
  std::optional<SimTime> change(const PinDrive& drive, SimTime t) {
    const bool output = drive.mode == PinMode::output && !drive.tone_hz;
    const bool high = output && !drive.pwm && drive.level;
    SimTime width = high_ && !high ? t - rose_ : 0;
    if (output && drive.pwm)
      width = static_cast<SimTime>(drive.duty * static_cast<double>(drive.period_us * kMicrosecond) + 0.5);
    if (high && !high_) rose_ = t;
    high_ = high;
    const bool is_pulse = width >= 300 * kMicrosecond && width <= 3 * kMillisecond;
    repeats_ = is_pulse && output && drive.pwm;
    if (!is_pulse) return std::nullopt;
    return width;
  }
  /// Whether pulses like the last one come until the next change.
  bool repeats() const { return repeats_; }

 private:
  bool high_ = false;
  bool repeats_ = false;
  SimTime rose_ = 0;
};

}  // namespace robosim::robot
