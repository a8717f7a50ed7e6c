// Formats manual pages in the language of man(7).
#pragma once

#include <string>
#include <vector>

#include "sim/cli/help.h"

namespace robosim::cli {

/// Returns the page robosim(1): the program's description, and its commands by task.
std::string man_page(const std::vector<CommandGroup>& groups);
/// Returns the page robosim-COMMAND(1) of a command.
std::string man_page(const CommandHelp& command);

}  // namespace robosim::cli
