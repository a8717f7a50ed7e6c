// `robosim replay`: shows a recorded run in the terminal.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Plays it if the standard output is a terminal; else prints how it ended. Returns 0. Throws InputError.
int replay_command(const ReplayArguments& arguments);

}  // namespace robosim::cli
