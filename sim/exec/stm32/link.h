// What the chip's peripherals share: the time, the interrupt controller, the board behind the pins.
#pragma once

#include "sim/exec/core/clocked_board.h"
#include "sim/exec/stm32/clock.h"
#include "sim/exec/stm32/nvic.h"

namespace robosim::exec::stm32 {

struct Link {
  ClockedBoard& board;
  Clock clock;
  Nvic nvic{};
};

}  // namespace robosim::exec::stm32
