// Predicts whether firmware that no longer accesses registers will stay inactive.
#pragma once

#include "sim/exec/stm32/firmware.h"
#include "sim/exec/stm32/machine.h"

namespace robosim::exec::stm32 {

/// Returns true for firmware with Robosim's core if only the core's interrupts for its clock, waits and
/// Serial are enabled. A sketch cannot observe their effects unless it calls the core. Also returns true if
/// interrupts are masked, an interrupt is pending, and no handler has begun for a second. The result does not
/// prove a loop: the firmware may be computing. Returns false for other firmware.
bool hangs(const Machine& machine, const Firmware& firmware);

}  // namespace robosim::exec::stm32
