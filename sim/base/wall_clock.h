// Measures wall time, only for progress lines and time limits, never for results of a run.
#pragma once

#include <cstdint>

namespace robosim {

/// Returns the microseconds since a fixed moment in the past; never decreases.
std::int64_t wall_us();

}  // namespace robosim
