// `robosim hunt`: what goes wrong with a sketch that nobody has written a test for (docs/hunting.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// The exit status: 1 if anything was found. Throws InputError, ToolMissing and wire::RunnerError.
int hunt_command(const HuntArguments& arguments);

}  // namespace robosim::cli
