// `robosim wire`: drafts a robot file from a sketch.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the process's exit status: 0 if a draft was made, good or bad. Throws the errors of run_command().
int wire_command(const WireArguments& arguments);

}  // namespace robosim::cli
