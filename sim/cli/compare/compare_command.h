// `robosim compare`: a sketch on several targets, and the first difference in what they do.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// The process's exit status: 1 if the targets differ. Throws InputError, ToolMissing and
/// client::RunnerError.
int compare_command(const CompareArguments& arguments);

}  // namespace robosim::cli
