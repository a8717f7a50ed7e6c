// Whether firmware that is silent will be silent for ever.
#pragma once

#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/watched_chip.h"

namespace robosim::exec::avr {

/// Proved, never guessed: the program goes round (sim/avr/recurrence.h), and of the interrupts that are
/// enabled none has a handler that could change what the round reads, or do something by itself. What a
/// handler may do is read from its code; of Serial's, which store by pointers, it is known that they touch
/// nothing but Serial. False where there is no proof. Takes some milliseconds.
bool hangs(const WatchedChip& chip, const Firmware& firmware);

}  // namespace robosim::exec::avr
