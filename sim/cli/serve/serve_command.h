// `robosim serve`.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Becomes the server's program. Throws InputError for a folder there is none of, ToolMissing where the
/// server was not built.
int serve_command(const ServeArguments& arguments);

}  // namespace robosim::cli
