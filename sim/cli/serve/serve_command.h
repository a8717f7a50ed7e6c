// `robosim serve`: starts the web server (sim/view/serve).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Replaces this process with the program robosim-serve. Throws InputError for a missing folder, ToolMissing
/// if the server was not built.
int serve_command(const ServeArguments& arguments);

}  // namespace robosim::cli
