// Detects silent firmware that will be silent for ever.
#pragma once

#include "sim/exec/stm32/firmware.h"
#include "sim/exec/stm32/machine.h"

namespace robosim::exec::stm32 {

/// For firmware with Robosim's core: returns true if only interrupts of the core's own clock, waits and
/// Serial are enabled. They change nothing that a sketch could see without a call. Also returns true if
/// interrupts are masked, and none has come for a second though one is pending. That the firmware loops is
/// not proved: it may be computing. Returns false for other firmware.
bool hangs(const Machine& machine, const Firmware& firmware);

}  // namespace robosim::exec::stm32
