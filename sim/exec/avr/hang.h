// Whether firmware that is silent will be silent for ever.
#pragma once

#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/watched_chip.h"

namespace robosim::exec::avr {

/// Proved, never guessed: the program goes round (sim/avr/recurrence.h), and the interrupts that are enabled
/// are the Arduino core's, whose handlers cannot change what the round reads. What the clock's may do is read
/// from its code; of Serial's, which store by pointers, it is known that they touch nothing but Serial. Any
/// handler of the sketch's own is life, also one that only counts: the host cannot tell those apart. False
/// where there is no proof. Takes some milliseconds.
bool hangs(const WatchedChip& chip, const Firmware& firmware);

}  // namespace robosim::exec::avr
