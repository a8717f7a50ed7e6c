// Predicts the reads of an I/O register, until an event occurs or a register is written.
#pragma once

#include <cstdint>

#include "sim/avr/cycle.h"

namespace robosim::avr {

struct ReadForecast {
  Cycle until = 0;         ///< for reads before this cycle; 0 = none
  std::uint8_t value = 0;  ///< of a read at present
  Cycle step = kNoCycle;   ///< the first read with one more ...
  Cycle period = 0;        ///< ... and the period of further increments; 0 = never

  bool counts() const { return period != 0; }
  std::uint8_t value_at(Cycle at) const {
    return static_cast<std::uint8_t>(counts() && at >= step ? value + 1 + (at - step) / period : value);
  }
  /// Returns the first read with `aim`, which is more than `value`.
  Cycle reaches(int aim) const { return step + static_cast<Cycle>(aim - value - 1) * period; }
};

}  // namespace robosim::avr
