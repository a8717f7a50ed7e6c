// Runs a command line in the programs `robosim` and `robosim-campaign`.
#pragma once

#include <functional>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses the words after the program's name, and performs the command. Reports errors on standard error.
/// Returns the exit status.
int run_program(int count, char** words, const std::function<int(const Command&)>& perform);

}  // namespace robosim::cli
