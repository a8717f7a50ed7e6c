// What the chip's peripherals share: the chip, the board behind its pins, and the time (by the chip's own
// clock).
#pragma once

#include "hal/board/sim_time.h"
#include "sim/exec/avr/chip.h"
#include "sim/exec/core/clocked_board.h"

namespace robosim::exec::avr {

struct Link {
  Chip& chip;
  ClockedBoard& board;
  SimTime began = 0;  ///< when the power came on, at cycle 0

  /// 16 MHz: a cycle is 62.5 ns, converted from the absolute count.
  SimTime time_of(Cycle cycle) const { return began + static_cast<SimTime>(cycle) * 125 / 2; }
  /// The first cycle at or after `t`.
  Cycle cycle_at(SimTime t) const {
    return t <= began ? 0 : static_cast<Cycle>(((t - began) * 2 + 124) / 125);
  }
  SimTime now() const { return time_of(chip.cycle()); }
};

}  // namespace robosim::exec::avr
