// What the chip's peripherals share: the chip, the board behind its pins, and the time.
#pragma once

#include <algorithm>

#include "hal/board/sim_time.h"
#include "sim/exec/avr/chip.h"
#include "sim/exec/core/board_state.h"
#include "sim/exec/core/firmware_clock.h"

namespace robosim::exec::avr {

struct Link {
  Chip& chip;
  BoardState& board;
  const FirmwareClock& clock;
  SimTime began = 0;       ///< when the power came on, at cycle 0, by the chip's clock
  SimTime limit = kNever;  ///< end of the tick: an instruction may begin before it and end behind it

  /// 16 MHz: a cycle is 62.5 ns by the chip's clock, converted from the absolute count.
  SimTime time_of(Cycle cycle) const { return clock.to_world(began + static_cast<SimTime>(cycle) * 125 / 2); }
  /// The first cycle at or after `t`.
  Cycle cycle_at(SimTime t) const {
    const SimTime own = clock.to_firmware(t);
    return own <= began ? 0 : static_cast<Cycle>(((own - began) * 2 + 124) / 125);
  }
  SimTime now() const { return std::min(time_of(chip.cycle()), limit); }
};

}  // namespace robosim::exec::avr
