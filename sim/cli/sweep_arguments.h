// The command line of `robosim sweep`.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// `words` after "sweep". Throws InputError.
Command parse_sweep(const std::vector<std::string>& words);

/// The value of --jobs; empty = one for each core. Throws InputError.
std::size_t number_of_jobs(const std::string& text);

}  // namespace robosim::cli
