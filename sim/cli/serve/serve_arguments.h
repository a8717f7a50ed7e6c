// The command line of `robosim serve`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, which follow the command's name on the command line. Throws InputError.
Command parse_serve(const std::vector<std::string>& words);

}  // namespace robosim::cli
