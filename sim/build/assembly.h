// Changes to gcc's assembly of a sketch for the host (x86-64, arm64 and arm) before it is assembled.
#pragma once

#include <string>
#include <string_view>

#include "sim/build/division.h"

namespace robosim::build {

/// Returns `assembly` with three changes:
/// - A jump to itself becomes a call of `robosim_endless_loop`, which hal/host defines: it never returns and
///   lets simulated time pass. gcc's trace-pc instruments blocks that do something; an empty endless loop
///   (`for (;;);`, `while (1);`) does nothing, so no time would pass in it.
/// - A division gives what the chip gives (division.h).
/// - The place of an asm() is written so that the assembler names the sketch's file and line where it refuses
///   what asm() holds. gcc writes that place as a comment, which assemblers read if it begins with '#'; for
///   arm64 and arm it begins otherwise.
std::string changed_for_host(std::string_view assembly, QuotientByZero quotient);

}  // namespace robosim::build
