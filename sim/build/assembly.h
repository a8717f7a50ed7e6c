// Changes gcc's assembly of a sketch for the host (x86-64, arm64 and arm) before it is assembled.
#pragma once

#include <string>
#include <string_view>

#include "sim/build/division.h"

namespace robosim::build {

/// Returns `assembly` with three changes:
/// - A jump to itself becomes a call of `robosim_endless_loop` in hal/host, which never returns and lets
///   simulated time pass. Otherwise no time would pass in an empty endless loop (`for (;;);`, `while (1);`):
///   gcc's trace-pc instruments only blocks with instructions.
/// - A division gets the chip's result (division.h).
/// - The place of an asm() is written so that the assembler's errors name the sketch's file and line. gcc
///   writes the place as a comment, which assemblers read only if it begins with '#'. For arm64 and arm,
///   gcc's comments begin with other marks.
std::string changed_for_host(std::string_view assembly, QuotientByZero quotient);

}  // namespace robosim::build
