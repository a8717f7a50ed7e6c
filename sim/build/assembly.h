// Changes to gcc's assembly of a sketch for the host (x86-64, arm64 and arm) before it is assembled.
#pragma once

#include <string>
#include <string_view>

#include "hal/board/board_spec.h"

namespace robosim::build {

/// Replaces each jump to itself by a call of `robosim_endless_loop`, which hal/host defines: it never
/// returns, and lets simulated time pass. gcc's trace-pc instruments blocks that do something; an empty
/// endless loop (`for (;;);`, `while (1);`) does nothing, so no time would pass in it.
std::string call_in_endless_loops(std::string_view assembly);

/// Lets the assembler name the sketch's file and line where it refuses what asm() holds. gcc writes that
/// place as a comment, which assemblers understand if it begins with '#'; for arm64 and arm it begins
/// otherwise.
std::string with_places_of_asm(std::string_view assembly);

/// Both, and divisions as the board's chip has them (division.h).
std::string changed_for_host(std::string_view assembly, const BoardSpec& board);

}  // namespace robosim::build
