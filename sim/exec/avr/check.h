// What a check in an image built for checking (build::Request::sanitize) has found: gcc's data for it, read
// from the chip's memory, where pointers and `unsigned` have 16 bits.
#pragma once

#include <optional>

#include "sim/exec/avr/watched_chip.h"
#include "sim/exec/host/undefined.h"

namespace robosim::exec::avr {

/// If the chip has stopped in a check's handler (hal/avr/undefined.c).
std::optional<Undefined> failed_check(const Firmware& firmware, const WatchedChip& chip, const Fault& fault);

}  // namespace robosim::exec::avr
