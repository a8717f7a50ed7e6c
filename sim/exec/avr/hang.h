// Proves that silent firmware will be silent for ever.
#pragma once

#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/watched_chip.h"

namespace robosim::exec::avr {

/// Returns whether that is proved: the program loops (sim/avr/infinite_loop.h), and no enabled handler can
/// change what the loop reads. All these handlers are the Arduino core's. The effects of the clock's handler
/// are read from its code. Serial's handlers store by pointers; they are known to change nothing except
/// Serial. Any enabled handler of the sketch counts as activity, even if it only increments a counter: the
/// host cannot distinguish those. Returns false without proof. Takes some milliseconds.
bool hangs(const WatchedChip& chip, const Firmware& firmware);

}  // namespace robosim::exec::avr
