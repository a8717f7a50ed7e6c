// `robosim mutate`: how many small bugs the checks of a sketch find (docs/mutation.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// The exit status. Throws InputError, ToolMissing and client::RunnerError.
int mutate_command(const MutateArguments& arguments);

}  // namespace robosim::cli
