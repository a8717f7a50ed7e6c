// `robosim replay`: a recorded run, in the terminal.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Plays it where the standard output is a terminal; else prints how it ended. Gives 0.
/// Throws InputError.
int replay_command(const ReplayArguments& arguments);

}  // namespace robosim::cli
