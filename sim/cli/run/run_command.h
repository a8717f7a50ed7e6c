// `robosim run`: sketch to image, image to verdict, verdict to screen, files or JSON.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// The process's exit status. Throws InputError, ToolMissing and client::RunnerError.
int run_command(const RunArguments& arguments);

}  // namespace robosim::cli
