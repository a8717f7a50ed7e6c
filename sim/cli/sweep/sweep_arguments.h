// The command line of `robosim sweep`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, which follow "sweep" on the command line. Throws InputError.
Command parse_sweep(const std::vector<std::string>& words);

}  // namespace robosim::cli
