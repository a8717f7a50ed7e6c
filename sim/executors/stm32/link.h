// What the chip's peripherals need of each other: the time, the interrupt controller, the board behind the
// pins.
#pragma once

#include "sim/executors/board_state.h"
#include "sim/executors/stm32/clock.h"
#include "sim/executors/stm32/nvic.h"

namespace robosim::executors::stm32 {

struct Link {
  BoardState& board;
  Clock clock;
  Nvic nvic{};
};

}  // namespace robosim::executors::stm32
