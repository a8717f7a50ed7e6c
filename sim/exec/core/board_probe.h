// What a simulation may look at and change inside the board, past firmware and robot: faults of the memory,
// and what a verdict says of a pin.
#pragma once

#include <cstdint>
#include <span>

#include "hal/board/board.h"

namespace robosim::exec {

/// What firmware has done with a pin since the run began, other than driving it.
struct PinUse {
  bool read = false;       ///< as a digital input, if only along with its port
  bool looked_at = false;  ///< and not only along with its port
  bool measured = false;   ///< by the ADC
  bool pulled_up = false;  ///< its pull-up was on
  bool awaited = false;    ///< its edges were wanted: by an interrupt, or a counter
  bool was_low = false, was_high = false;
  double lowest_volts = 0.0, highest_volts = 0.0;  ///< where measured
  SimTime last_seen = -1;                          ///< when it was read or measured last; -1 = never
};

class BoardProbe {
 public:
  /// The EEPROM as it holds now, of spec().eeprom_bytes.
  virtual std::span<std::uint8_t> memory() = 0;
  /// What firmware would read; may consume a sample of noise.
  virtual bool level(Pin pin, SimTime t) = 0;
  virtual const PinUse& use(Pin pin) const = 0;

 protected:
  ~BoardProbe() = default;
};

}  // namespace robosim::exec
