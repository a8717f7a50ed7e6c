// Proves that firmware which no longer accesses I/O will never access I/O again.
#pragma once

#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/watched_chip.h"

namespace robosim::exec::avr {

/// Returns whether the firmware provably hangs. Takes some milliseconds. The proof requires an infinite loop
/// (sim/mcu/avr/infinite_loop.h). No enabled handler may change memory that the loop reads.
///
/// All enabled handlers must belong to the Arduino core. The code of the handler that counts millis() shows
/// which memory this handler changes. Serial's handlers store through pointers, and are known to change only
/// Serial. Any enabled handler of the sketch counts as activity, even if the handler only increments a
/// counter.
bool hangs(const WatchedChip& chip, const Firmware& firmware);

}  // namespace robosim::exec::avr
