// The command line of `robosim hunt`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, which follow "hunt" on the command line. Throws InputError.
Command parse_hunt(const std::vector<std::string>& words);

}  // namespace robosim::cli
