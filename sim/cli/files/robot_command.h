// `robosim robot list|show|check`
#pragma once

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the process's exit status. Throws InputError and client::RunnerError.
int robot_command(const RobotArguments& arguments);

}  // namespace robosim::cli
