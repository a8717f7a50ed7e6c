// Defines the unit of time inside a chip: cycles of the processor's clock since power-on.
#pragma once

#include <cstdint>
#include <limits>

namespace robosim::avr {

using Cycle = std::uint64_t;
constexpr Cycle kNoCycle = std::numeric_limits<Cycle>::max();  ///< never

}  // namespace robosim::avr
