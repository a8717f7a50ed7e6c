// The command line of `robosim mutate`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, after "mutate". Throws InputError.
Command parse_mutate(const std::vector<std::string>& words);

}  // namespace robosim::cli
