// `robosim classic`: runs a robot that moves from cell to cell.
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the exit status.
int classic_command(const ClassicArguments& arguments);

}  // namespace robosim::cli
