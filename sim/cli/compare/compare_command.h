// `robosim compare`: runs a sketch on several targets, and finds the first difference in its behaviour.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the process's exit status: 1 if the targets differ. Throws InputError, ToolMissing and
/// wire::RunnerError.
int compare_command(const CompareArguments& arguments);

}  // namespace robosim::cli
