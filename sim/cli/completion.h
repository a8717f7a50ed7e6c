// Generates code that completes robosim's commands, options and values in a shell.
#pragma once

#include <string>
#include <vector>

#include "sim/cli/help.h"

namespace robosim::cli {

/// Returns the code for `shell`: bash, zsh or fish.
std::string completion(const std::string& shell, const std::vector<CommandGroup>& groups);

}  // namespace robosim::cli
