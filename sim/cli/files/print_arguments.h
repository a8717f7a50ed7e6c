// The command line of `robosim map print`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, which follow the command's name on the command line. Throws InputError.
Command parse_print(const std::vector<std::string>& words);

}  // namespace robosim::cli
