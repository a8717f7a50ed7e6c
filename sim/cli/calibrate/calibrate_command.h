// `robosim calibrate`: computes parameters of a robot file from logs of the real robot
// (docs/howto/calibrating.md).
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Fits the robot's parameters to the logs and prints the results. Writes the fitted robot if the arguments
/// name a file for it. Throws InputError; in this case, no file has been written.
int calibrate_command(const CalibrateArguments& arguments);

}  // namespace robosim::cli
