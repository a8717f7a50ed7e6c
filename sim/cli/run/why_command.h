// `robosim why`: traces a run's verdict back to its causes (docs/howto/why.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Runs the command. Throws InputError and ToolMissing. Returns the exit status of the verdict, as for `run`.
int why_command(const WhyArguments& arguments);

}  // namespace robosim::cli
