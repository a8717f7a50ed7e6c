// Measures the lengths of the pulses on a servo's signal wire.
//
// A hobby servo responds to the width of a pulse, some 0.5 to 2.5 ms, every 20 ms or so. The repetition rate
// is irrelevant. Pulses shorter than 0.3 ms or longer than 3 ms are ignored. Pulses are derived from changes
// of the pin's level. If a timer or a PWM driver makes the pulses, they are derived from duty cycle and
// period. A change of the PWM then applies at once, not at the end of the period. PWM of unknown period makes
// no pulses.
#pragma once

#include <optional>

#include "hal/board/board.h"

namespace robosim::robot {

/// The state of the wire, as a copyable value.
class ServoSignal {
 public:
  /// Handles a change of the drive at `t`. Returns the length of the pulse that ends with the change. If PWM
  /// makes the pulses, returns the length of the pulses from now on. Returns nullopt if there is no pulse, or
  /// its length is out of range.
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
  /// Returns whether pulses like the last one continue until the next change.
  bool repeats() const { return repeats_; }

 private:
  bool high_ = false;
  bool repeats_ = false;
  SimTime rose_ = 0;
};

}  // namespace robosim::robot
