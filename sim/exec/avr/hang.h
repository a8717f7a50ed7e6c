// Proves that silent firmware will stay silent forever.
#pragma once

#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/watched_chip.h"

namespace robosim::exec::avr {

/// Returns whether the firmware provably hangs; false if there is no proof. Proof requires an infinite loop
/// (sim/mcu/avr/infinite_loop.h), and that no enabled handler can change memory that the loop reads. All
/// enabled handlers must belong to the Arduino core. The code of the clock's handler shows which memory it
/// changes. Serial's handlers store through pointers, and are known to change only Serial. Any enabled
/// handler of the sketch counts as activity, even if it only increments a counter. Takes some milliseconds.
bool hangs(const WatchedChip& chip, const Firmware& firmware);

}  // namespace robosim::exec::avr
