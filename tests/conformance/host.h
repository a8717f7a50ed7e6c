// Runs the programs on the target host.
#pragma once

#include "tests/conformance/program.h"

namespace robosim::conformance {

/// The chip that the host models, by its avr-gcc name.
constexpr const char* kHostChip = "atmega328p";

/// Compiles the program like a sketch, and runs it on the target host. If the program does not compile,
/// returns an empty report, in which `ended` is false.
Report run_on_host(const Program& program);

}  // namespace robosim::conformance
