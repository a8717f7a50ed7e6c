// `robosim serve`.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Replaces this process by the server's program. Throws InputError for a missing folder, ToolMissing if the
/// server was not built.
int serve_command(const ServeArguments& arguments);

}  // namespace robosim::cli
