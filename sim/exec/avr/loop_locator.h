// Finds, in an image for an AVR, the instructions at which a round of loop() begins.
#pragma once

#include "sim/exec/avr/firmware.h"
#include "sim/exec/elf/debug_info.h"
#include "sim/exec/elf/loop_marker.h"

namespace robosim::exec::avr {

/// Returns the instructions that mark the rounds of loop() (sim/exec/elf/loop_locator.h).
LoopMarks locate_loop(const Firmware& firmware, const DebugInfo& debug);

}  // namespace robosim::exec::avr
