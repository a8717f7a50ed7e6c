// What the chip's peripherals need of each other: the chip, the board behind its pins, and the time.
#pragma once

#include <algorithm>

#include "hal/board/sim_time.h"
#include "sim/executors/avr/chip.h"
#include "sim/executors/board_state.h"

namespace robosim::executors::avr {

struct Link {
  Chip& chip;
  BoardState& board;
  SimTime began = 0;       ///< when the power came on, at cycle 0
  SimTime limit = kNever;  ///< end of the tick: an instruction may begin before it and end behind it

  /// 16 MHz: a cycle is 62.5 ns, converted from the absolute count.
  SimTime time_of(Cycle cycle) const { return began + static_cast<SimTime>(cycle) * 125 / 2; }
  /// The first cycle at or after `t`.
  Cycle cycle_at(SimTime t) const {
    return t <= began ? 0 : static_cast<Cycle>(((t - began) * 2 + 124) / 125);
  }
  SimTime now() const { return std::min(time_of(chip.cycle()), limit); }
};

}  // namespace robosim::executors::avr
