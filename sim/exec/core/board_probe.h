// The simulation's access to the inside of the board, past firmware and robot. It serves memory faults, and
// what verdicts report about pins.
#pragma once

#include <cstdint>
#include <span>

#include "hal/board/board.h"

namespace robosim::exec {

/// The ways in which firmware has used a pin since the run began, other than driving it.
struct PinUse {
  bool read = false;       ///< as a digital input, even if only along with its port
  bool looked_at = false;  ///< as a digital input by itself, not only along with its port
  bool measured = false;   ///< by the ADC
  bool pulled_up = false;  ///< its pull-up was on
  bool awaited = false;    ///< something waited for its edges: an interrupt, or a counter
  bool was_low = false, was_high = false;
  double lowest_volts = 0.0, highest_volts = 0.0;  ///< of the measurements
  SimTime last_seen = -1;                          ///< time of the last read or measurement; -1 = never
};

class BoardProbe {
 public:
  /// Returns the present content of the EEPROM, spec().eeprom_bytes long.
  virtual std::span<std::uint8_t> memory() = 0;
  /// Returns the level that firmware would read; may consume a sample of noise.
  virtual bool level(Pin pin, SimTime t) = 0;
  virtual const PinUse& use(Pin pin) const = 0;

 protected:
  ~BoardProbe() = default;
};

}  // namespace robosim::exec
