// Finds, in an image for an STM32F103, the instructions at which a round of loop() begins.
#pragma once

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/elf/loop_marker.h"
#include "sim/exec/stm32/firmware.h"

namespace robosim::exec::stm32 {

/// Returns the instructions that mark the rounds of loop() (sim/exec/elf/loop_locator.h).
LoopMarks locate_loop(const Firmware& firmware, const DebugInfo& debug);

}  // namespace robosim::exec::stm32
