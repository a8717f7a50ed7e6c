// The command line of `robosim mutate`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, which follow "mutate" on the command line. Throws InputError.
Command parse_mutate(const std::vector<std::string>& words);

}  // namespace robosim::cli
