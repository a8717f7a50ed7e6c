// The command line of `robosim report`.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

Command parse_report(const std::vector<std::string>& words);

}  // namespace robosim::cli
