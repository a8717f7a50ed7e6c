// What a logic analyser would show of a pin.
#pragma once

#include "sim/wire/stream.h"

namespace robosim::record {

enum class PinLevel { low = 0, high = 1, floating = 2, pulsing = 3 };

/// Pulsing: driven by PWM or tone(), faster than each edge is told. A pull-up without more is high.
inline PinLevel level_of(const wire::PinChange& pin) {
  if (pin.mode == "input_pullup") return PinLevel::high;
  if (pin.mode != "output") return PinLevel::floating;
  if (pin.tone_hz > 0 || (pin.pwm && pin.duty > 0.0 && pin.duty < 1.0)) return PinLevel::pulsing;
  return pin.duty >= 0.5 ? PinLevel::high : PinLevel::low;
}

}  // namespace robosim::record
