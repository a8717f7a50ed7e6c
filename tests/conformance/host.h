// Runs the programs on the target host.
#pragma once

#include "tests/conformance/program.h"

namespace robosim::conformance {

/// The chip that the host models, by its avr-gcc name.
constexpr const char* kHostChip = "atmega328p";

/// Compiles the program like a sketch, and runs it on the target host. The report of a program that does not
/// compile is empty, and has not ended.
Report run_on_host(const Program& program);

}  // namespace robosim::conformance
