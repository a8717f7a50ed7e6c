// `robosim play`: an interactive session in the style of Robosim v1, the original program.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Runs the session. Uses the whole screen of a terminal that can address its cursor; otherwise reads and
/// writes lines. Returns the exit status: 130 after Ctrl-C. Throws InputError for the map or start in the
/// arguments.
int play_command(const PlayArguments& arguments);

}  // namespace robosim::cli
