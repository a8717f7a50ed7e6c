// The command line of `robosim sweep`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, after "sweep". Throws InputError.
Command parse_sweep(const std::vector<std::string>& words);

}  // namespace robosim::cli
