// The registers' names inside the emulated chip.
#pragma once

#include "hal/board/avr_registers.h"

namespace robosim::exec::avr {

namespace reg = robosim::avr::reg;

}  // namespace robosim::exec::avr
