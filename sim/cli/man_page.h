// Manual pages, in the language of man(7).
#pragma once

#include <string>
#include <vector>

#include "sim/cli/help.h"

namespace robosim::cli {

/// Returns robosim(1): the program's description, and its commands by task.
std::string man_page(const std::vector<CommandGroup>& groups);
/// Returns robosim-COMMAND(1).
std::string man_page(const CommandHelp& command);

}  // namespace robosim::cli
