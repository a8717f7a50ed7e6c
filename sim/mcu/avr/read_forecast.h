// Predicts reads of an I/O register until an event occurs or a register is written.
#pragma once

#include <cstdint>

#include "sim/mcu/avr/cycle.h"

namespace robosim::avr {

struct ReadForecast {
  Cycle until = 0;         ///< valid for reads before this cycle; 0 = no forecast
  std::uint8_t value = 0;  ///< result of a read now
  Cycle step = kNoCycle;   ///< first cycle at which a read returns value + 1
  Cycle period = 0;        ///< period of further increments; 0 = no increments

  bool counts() const { return period != 0; }
  std::uint8_t value_at(Cycle at) const {
    return static_cast<std::uint8_t>(counts() && at >= step ? value + 1 + (at - step) / period : value);
  }
  /// Returns the cycle of the first read that returns `aim`, which must exceed `value`.
  Cycle reaches(int aim) const { return step + static_cast<Cycle>(aim - value - 1) * period; }
};

}  // namespace robosim::avr
