// Predicts whether firmware that no longer accesses peripherals will never access peripherals again.
#pragma once

#include "sim/exec/stm32/firmware.h"
#include "sim/exec/stm32/machine.h"

namespace robosim::exec::stm32 {

/// Returns whether the firmware probably hangs. Call it only if the firmware has not accessed a peripheral
/// for some time. Returns false for firmware without Robosim's Arduino core, and while the independent
/// watchdog runs.
///
/// Returns true if only the core's interrupts for its clock, waits and Serial are enabled. A sketch that does
/// not call the core cannot observe the effects of these interrupts. Also returns true if interrupts are
/// masked, an interrupt is pending, and no handler has begun for a second. The result does not prove a loop,
/// because the firmware may be computing.
bool hangs(const Machine& machine, const Firmware& firmware);

}  // namespace robosim::exec::stm32
