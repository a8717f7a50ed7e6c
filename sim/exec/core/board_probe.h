// What a simulation may look at and change inside the board, past firmware and robot: faults of the memory,
// and what a verdict says of a pin.
#pragma once

#include <cstdint>
#include <span>

#include "hal/board/board.h"

namespace robosim::exec {

class BoardProbe {
 public:
  /// The EEPROM as it holds now, of spec().eeprom_bytes.
  virtual std::span<std::uint8_t> memory() = 0;
  /// What firmware would read; may consume a sample of noise.
  virtual bool level(Pin pin, SimTime t) = 0;

 protected:
  ~BoardProbe() = default;
};

}  // namespace robosim::exec
