// Explains a failed check of an image that was built with the checks of gcc's UndefinedBehaviorSanitizer
// (build::Request::sanitize). Reads gcc's data about the check from the chip's memory, where pointers and
// `unsigned` have 16 bits.
#pragma once

#include <optional>

#include "sim/exec/avr/watched_chip.h"
#include "sim/exec/host/undefined.h"

namespace robosim::exec::avr {

/// Returns the failed check, if the chip has stopped in a check's handler (hal/avr/undefined.c).
std::optional<Undefined> failed_check(const Firmware& firmware, const WatchedChip& chip, const Fault& fault);

}  // namespace robosim::exec::avr
