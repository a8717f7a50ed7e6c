// `robosim calibrate`: computes parameters of a robot file from logs of the real robot
// (docs/howto/calibrating.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Reports the results from the logs, and writes them if a file is named. Throws InputError before writing
/// anything.
int calibrate_command(const CalibrateArguments& arguments);

}  // namespace robosim::cli
