// Changes gcc's assembly output for the host (x86-64, arm64 and arm), before the assembler reads it.
#pragma once

#include <string>
#include <string_view>

#include "sim/build/division.h"

namespace robosim::build {

/// Returns `assembly` with three changes:
/// - An instruction that jumps to itself becomes a call of `robosim_endless_loop` in hal/host, which never
///   returns and lets simulated time pass. Otherwise no time would pass in an empty endless loop
///   (`for (;;);`, `while (1);`): gcc's trace-pc instruments only blocks with instructions.
/// - A division gives the result that the chip would compute (division.h).
/// - The source location of an asm() becomes a comment that begins with '#'. The assembler's errors then name
///   the sketch's file and line. Without this change, assemblers for arm64 and arm ignore the location,
///   because gcc begins the comment with `//` or `@`.
std::string changed_for_host(std::string_view assembly, QuotientByZero quotient);

}  // namespace robosim::build
