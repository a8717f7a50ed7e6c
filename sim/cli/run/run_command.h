// `robosim run`: builds a sketch, runs it, and shows the verdict on screen, in files or as JSON.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the process's exit status. Throws InputError, ToolMissing and wire::RunnerError.
int run_command(const RunArguments& arguments);

}  // namespace robosim::cli
