// `robosim mutate`: measures how many small bugs a sketch's checks find (docs/howto/mutation.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the exit status. Throws InputError, ToolMissing and wire::RunnerError.
int mutate_command(const MutateArguments& arguments);

}  // namespace robosim::cli
