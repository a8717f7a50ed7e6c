// Wall time, for progress lines and time limits only; never for what a run computes.
#pragma once

#include <cstdint>

namespace robosim {

/// Returns the microseconds since some moment in the past; never goes back.
std::int64_t wall_us();

}  // namespace robosim
