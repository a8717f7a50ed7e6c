// `robosim run` with several robots (docs/howto/fleets.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the exit status: 0 if all robots reached their goals.
int fleet_command(const RunArguments& arguments);

}  // namespace robosim::cli
