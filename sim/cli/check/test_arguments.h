// The command lines of `robosim test` and `robosim new`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, after "test". Throws InputError.
Command parse_test(const std::vector<std::string>& words);
/// Parses `words`, after "new". Throws InputError.
Command parse_new(const std::vector<std::string>& words);

}  // namespace robosim::cli
