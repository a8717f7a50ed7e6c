// gcc's trace-pc instruments blocks that do something. An empty endless loop (`for (;;);`, `while (1);`) does
// nothing, so no time would pass in it. It is a jump to itself in the assembly, and is found there.
#pragma once

#include <string>
#include <string_view>

namespace robosim::sketch {

/// Replaces each jump to itself by a call of `robosim_endless_loop`, which hal/host defines: it never
/// returns, and lets simulated time pass. Understands gcc's assembly for x86-64, arm64 and arm.
std::string call_in_endless_loops(std::string_view assembly);

}  // namespace robosim::sketch
