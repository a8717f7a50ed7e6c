// The command line of `robosim why`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

Command parse_why(const std::vector<std::string>& words);

}  // namespace robosim::cli
