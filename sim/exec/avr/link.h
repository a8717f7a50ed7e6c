// What the chip's peripherals share: the chip, the board behind its pins, and the time (by the chip's own
// clock).
#pragma once

#include "hal/board/cycle_time.h"
#include "sim/exec/avr/chip.h"
#include "sim/exec/core/clocked_board.h"

namespace robosim::exec::avr {

struct Link {
  Chip& chip;
  ClockedBoard& board;
  const CycleTime cycles;  ///< how long the chip's take by its own clock
  SimTime began = 0;       ///< when the power came on, at cycle 0

  SimTime time_of(Cycle cycle) const { return began + cycles.of(static_cast<SimTime>(cycle)); }
  /// The first cycle at or after `t`.
  Cycle cycle_at(SimTime t) const { return t <= began ? 0 : static_cast<Cycle>(cycles.first_at(t - began)); }
  SimTime now() const { return time_of(chip.cycle()); }
};

}  // namespace robosim::exec::avr
