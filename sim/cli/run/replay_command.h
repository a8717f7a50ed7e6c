// `robosim replay`: shows a recorded run in the terminal.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Plays the recording if the standard output is a terminal; otherwise prints its result. Returns 0. Throws
/// InputError.
int replay_command(const ReplayArguments& arguments);

}  // namespace robosim::cli
