// Changes gcc's assembly output for the host (x86-64, arm64 and arm), before the assembler reads it.
#pragma once

#include <string>
#include <string_view>

#include "sim/build/division.h"

namespace robosim::build {

/// Returns `assembly` with three changes:
/// - An instruction that jumps to itself becomes a call of `robosim_endless_loop` (hal/host). This function
///   never returns, and lets simulated time pass. Without the call, no time would pass in an empty endless
///   loop such as `while (1);`. Time is counted by calls that gcc inserts (trace-pc), but gcc inserts them
///   only into blocks with instructions.
/// - A division gives the result that the chip would compute (division.h).
/// - The source location of an asm() becomes a comment that begins with '#'. The assembler's errors then name
///   the sketch's file and line. Without this change, assemblers for arm64 and arm ignore the location,
///   because gcc begins the comment with `//` or `@`.
std::string changed_for_host(std::string_view assembly, QuotientByZero quotient);

}  // namespace robosim::build
