// Gives the simulation direct access to the board, bypassing firmware and robot. The simulation uses it to
// inject memory faults, and to report in verdicts how pins were used.
#pragma once

#include <cstdint>
#include <span>

#include "hal/board/board.h"

namespace robosim::exec {

/// How firmware has used a pin since the run began, other than by driving it.
struct PinUse {
  bool read = false;       ///< was read as a digital input, alone or with all pins of its port
  bool looked_at = false;  ///< was read as a digital input, without the other pins of its port
  bool measured = false;   ///< was measured by the ADC
  bool pulled_up = false;  ///< the pin's pull-up was switched on
  bool awaited = false;    ///< an interrupt or a counter waited for edges of the pin
  bool was_low = false, was_high = false;
  double lowest_volts = 0.0, highest_volts = 0.0;  ///< range of the measurements
  SimTime last_seen = -1;                          ///< time of the last read or measurement; -1 = never
};

class BoardProbe {
 public:
  /// Returns the present content of the EEPROM, spec().eeprom_bytes long.
  virtual std::span<std::uint8_t> memory() = 0;
  /// Returns the level that firmware would read. The call may consume a random value of the sensor's noise,
  /// so that later reads differ.
  virtual bool level(Pin pin, SimTime t) = 0;
  virtual const PinUse& use(Pin pin) const = 0;

 protected:
  ~BoardProbe() = default;
};

}  // namespace robosim::exec
