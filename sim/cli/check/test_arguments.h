// The command lines of `robosim test` and `robosim new`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, which follow "test" on the command line. Throws InputError.
Command parse_test(const std::vector<std::string>& words);
/// Parses `words`, which follow "new" on the command line. Throws InputError.
Command parse_new(const std::vector<std::string>& words);

}  // namespace robosim::cli
