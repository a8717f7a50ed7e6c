// `robosim hunt`: searches for bugs automatically, with random worlds, inputs and faults
// (docs/howto/hunting.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the exit status: 1 if anything was found. Throws InputError, ToolMissing and wire::RunnerError.
int hunt_command(const HuntArguments& arguments);

}  // namespace robosim::cli
