// Whether firmware that is silent will be silent for ever.
#pragma once

#include "sim/exec/stm32/firmware.h"
#include "sim/exec/stm32/machine.h"

namespace robosim::exec::stm32 {

/// Of firmware with Robosim's core: whether no interrupt is enabled but those of the core's own clock, waits
/// and Serial, which change nothing that a sketch could see without a call, or they are masked and none has
/// come for a second though one waits. That it goes round is not proved: it may be computing. False for other
/// firmware.
bool hangs(const Machine& machine, const Firmware& firmware);

}  // namespace robosim::exec::stm32
