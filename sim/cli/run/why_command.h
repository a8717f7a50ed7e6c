// `robosim why`: from a run's verdict back along what caused it (docs/why.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Throws InputError and ToolMissing. Returns the exit status: the verdict's, as `run` does.
int why_command(const WhyArguments& arguments);

}  // namespace robosim::cli
