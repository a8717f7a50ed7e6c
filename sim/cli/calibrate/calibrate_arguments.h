// The command line of `robosim calibrate`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, which follow "calibrate" on the command line. Throws InputError.
Command parse_calibrate(const std::vector<std::string>& words);

}  // namespace robosim::cli
