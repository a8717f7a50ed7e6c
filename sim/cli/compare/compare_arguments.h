// The command line of `robosim compare`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, which follow "compare" on the command line. Throws InputError.
Command parse_compare(const std::vector<std::string>& words);

}  // namespace robosim::cli
