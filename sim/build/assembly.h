// Changes to gcc's assembly of a sketch for the host (x86-64, arm64 and arm) before it is assembled.
#pragma once

#include <string>
#include <string_view>

#include "sim/build/division.h"

namespace robosim::build {

/// Returns `assembly` with three changes.
/// - A jump to itself becomes a call of `robosim_endless_loop`, which hal/host defines. It never returns and
///   lets simulated time pass. gcc's trace-pc instruments only blocks with instructions. In an empty endless
///   loop (`for (;;);`, `while (1);`) no time would pass.
/// - A division has the chip's result (division.h).
/// - The place of an asm() is written so that the assembler names the sketch's file and line in errors about
///   its content. gcc writes that place as a comment, which assemblers read if it begins with '#'; for arm64
///   and arm it begins otherwise.
std::string changed_for_host(std::string_view assembly, QuotientByZero quotient);

}  // namespace robosim::build
