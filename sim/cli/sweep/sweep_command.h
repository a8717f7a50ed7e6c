// `robosim sweep`: makes many runs in parallel.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the process's exit status: 1 if --min-rate is not met, 3 if a run failed because of an internal
/// error of Robosim, 130 after an interrupt. Throws InputError, ToolMissing and wire::RunnerError.
int sweep_command(const SweepArguments& arguments);

}  // namespace robosim::cli
